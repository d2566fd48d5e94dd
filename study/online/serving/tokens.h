#pragma once
#include <filesystem>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace seamline::study::online {

/// 256 bits from the system's generator, as 64 hexadecimal digits. Throws InputError when it has none.
[[nodiscard]] std::string random_secret();
/// 80 bits, as 16 letters a-z and digits 2-7.
[[nodiscard]] std::string random_letters();

/// Makes invitations, each good for one participant, and adds their hashes to a file (for its owner alone),
/// which is made when it is missing. Returns the invitations: they are stored nowhere. `tell` gets them
/// before their hashes are stored; when it throws nothing is stored.
std::vector<std::string> make_tokens(int count, const std::filesystem::path& file,
                                     const std::function<void(const std::vector<std::string>&)>& tell = {});

/// The hashes of a file of invitations. Throws InputError when it cannot be read or holds something else.
[[nodiscard]] std::set<std::string> read_token_hashes(const std::filesystem::path& file);

/// An invitation of a file, in the order in which they were made.
struct ListedInvitation {
  std::string token_sha256;
  bool used = false;
};
/// `used`: hashes that a log has used. Throws InputError as read_token_hashes does.
[[nodiscard]] std::vector<ListedInvitation> list_invitations(const std::filesystem::path& file,
                                                             const std::set<std::string>& used);

/// The secret of a file, which is made with a new one, for its owner alone, where it is missing. Throws
/// InputError when it cannot be read or written, or holds something else.
[[nodiscard]] std::string secret_of_file(const std::filesystem::path& file);

/// The code of whoever came by an invitation, or by a link with one (`...?token=INVITATION`), out of a file
/// of codes (`Invitations`). Throws InputError when the file cannot be read, or knows nobody who did.
[[nodiscard]] std::string code_of_invitation(const std::filesystem::path& file,
                                             const std::string& invitation);

/// A file of invitations as it is now: what is added to it, or taken out, counts from the next question on.
/// For several threads.
class Invitations {
 public:
  /// `say` hears when the file cannot be read; what it held before counts then. `codes`: the file in which
  /// the codes of those who came are kept beside the hashes of their invitations; empty: that is kept
  /// nowhere. Throws InputError when one of them cannot be read now.
  Invitations(std::filesystem::path file, std::function<void(const std::string&)> say,
              std::filesystem::path codes = {});
  [[nodiscard]] bool has(const std::string& token_sha256);
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// Notes the code where codes are kept (`InvitationCodes`). The same invitation again takes the place of
  /// its line. Throws InputError when it cannot.
  void note(const std::string& token_sha256, const std::string& code);

 private:
  void look();

  std::filesystem::path file_, codes_;
  std::function<void(const std::string&)> say_;
  std::mutex lock_;
  std::string seen_;  ///< what the file's entry in its folder said when it was read
  std::set<std::string> hashes_;
};

}  // namespace seamline::study::online
