#pragma once

namespace seamline {

/// Joins lambdas into one visitor for std::visit. Without a generic lambda among them, a new alternative of
/// the variant does not compile until every visit handles it.
template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace seamline
