#!/usr/bin/env python3
"""The figure of an exported page as X3D in XML, checked by xmllint.   figure_schema.py PAGE.html X3D.xsd OUT.x3d

The page has X3D in the HTML encoding of X3DOM, where capitals do not count; here names get those of the schema. Shaders of X3DOM's own form are
left out, and materials light the figure.
"""
import html.parser
import re
import subprocess
import sys
from xml.sax.saxutils import escape, quoteattr

PARTS = ("hanimhumanoid", "timesensor", "orientationinterpolator", "positioninterpolator", "route")


class Figure(html.parser.HTMLParser):
    def __init__(self, names):
        super().__init__(convert_charrefs=True)
        self.names, self.text, self.inside, self.left_out = names, "", [], []

    def handle_starttag(self, tag, attributes):
        if self.left_out or dict(attributes).get("class") == "by-shader":
            self.left_out.append(tag)
        elif self.inside or tag in PARTS:
            self.inside.append(tag)
            kept = [(self.names.get(k, k), v) for k, v in attributes if k != "id"]
            self.text += f"<{self.names.get(tag, tag)}" + "".join(f" {k}={quoteattr(v)}" for k, v in kept) + ">"

    def handle_endtag(self, tag):
        if self.left_out:
            self.left_out.pop()
        elif self.inside:
            assert self.inside.pop() == tag, tag
            self.text += f"</{self.names.get(tag, tag)}>\n"

    def handle_data(self, data):
        if self.inside and not self.left_out:
            self.text += escape(data)


def main():
    page, schema, out = sys.argv[1:]
    names = {}
    for kind in ("attribute", "element"):  # elements last: their names win
        names.update((n.lower(), n) for n in re.findall(rf'<xs:{kind} (?:name|ref)="([A-Za-z0-9_]+)"', open(schema).read()))
    names.update({"def": "DEF", "use": "USE", "color": "color", "normal": "normal", "shape": "Shape"})
    figure = Figure(names)
    figure.feed(open(page).read())
    text = figure.text
    for name in ("Color", "Normal", "Coordinate", "Group"):  # fields and nodes have one name in small letters
        text = re.sub(rf"(</?){name}\b", rf"\g<1>{name}", text, flags=re.I)
    with open(out, "w") as file:
        file.write('<?xml version="1.0" encoding="UTF-8"?>\n<X3D profile="Full" version="4.0"><Scene>\n' + text + "</Scene></X3D>\n")
    subprocess.run(["xmllint", "--noout", "--huge", "--schema", schema, out], check=True)


if __name__ == "__main__":
    main()
