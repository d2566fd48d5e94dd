# The manual as a site, from the pages that `stage` has prepared (Sphinx, MyST, Furo). `build` runs it.
import os

project = "Seamline"
author = "The Seamline developers"
copyright = "The Seamline developers, Apache-2.0"
version = release = os.environ.get("SEAMLINE_VERSION", "")
extensions = ["myst_parser"]
myst_heading_anchors = 4
myst_enable_extensions = ["html_image"]
root_doc = "index"
highlight_language = "none"  # what commands print is not code
html_theme = "furo"
html_title = "Seamline"
html_static_path = [os.path.join(os.path.dirname(__file__), "static")]
html_css_files = ["manual.css"]
html_js_files = ["manual.js"]
html_copy_source = False
html_show_sourcelink = False
html_last_updated_fmt = None
pygments_style = "tango"
pygments_dark_style = "monokai"


def setup(app):
    from pygments.lexers import TextLexer
    app.add_lexer("csv", TextLexer)  # Pygments has none
