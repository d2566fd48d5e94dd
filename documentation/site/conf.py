# The manual as a site, from the pages that `stage` has prepared (Sphinx, MyST, Furo). `build` runs it.
import os
import re

project = "Seamline"
author = "The Seamline developers"
copyright = "The Seamline developers, Apache-2.0"
version = release = os.environ.get("SEAMLINE_VERSION", "")
extensions = ["myst_parser"]
myst_heading_anchors = 4
myst_enable_extensions = ["html_image"]
root_doc = "index"
highlight_language = "none"  # what commands print is not code
smartquotes = False  # two hyphens are an option
html_theme = "furo"
html_title = "Seamline"
html_static_path = [os.path.join(os.path.dirname(__file__), "static")]
html_css_files = ["manual.css"]
html_js_files = ["manual.js"]
html_search_scorer = os.path.join(os.path.dirname(__file__), "scorer.js")
html_copy_source = False
html_show_sourcelink = False
html_last_updated_fmt = None
pygments_style = "tango"
pygments_dark_style = "monokai"


def whole_options(app, page, template, context, doctree):
    """A browser may break a line after each hyphen; an option of a command stays whole, and so do 5 %, a date and a short cell of a table."""
    def block(match):
        return re.sub(r"(?<![\w-])(--?[A-Za-z][\w-]*)", r'<span class="option">\1</span>', match[0])
    def aligned(match):  # columns of a formula or of what a command prints must not wrap
        text = re.sub(r"<[^>]*>", "", match[2])
        columns = re.search(r"\S {3,}[^\s#]|^\|", text, re.M) and not re.search(r"^(build/release/)?seamline ", text, re.M)
        return f'{match[1]} class="aligned">{match[2]}</pre>' if columns else match[0]
    body = re.sub(r'(<div class="highlight-(?:none|default) notranslate"><div class="highlight"><pre)>(.*?)</pre>', aligned, context.get("body", ""), flags=re.S)
    body = re.sub(r"<pre>.*?</pre>", block, body, flags=re.S)
    body = re.sub(r'<span class="pre">(--[\w-]+)</span>', r'<span class="pre option">\1</span>', body)
    body = re.sub(r"(?<=[ (>])(20\d\d-\d\d-\d\d)\b", r'<span class="whole">\1</span>', body)
    body = re.sub(r"(<td[^>]*>)<p>([^<]{1,16})</p>", r'\1<p class="whole">\2</p>', body)
    context["body"] = re.sub(r"(?<=\d) %", "\u00a0%", body)


def setup(app):
    from pygments.lexers import TextLexer
    for language in ("csv", "sh"):  # Pygments has no csv, and colours half of a number in a command
        app.add_lexer(language, TextLexer)
    app.connect("html-page-context", whole_options)
