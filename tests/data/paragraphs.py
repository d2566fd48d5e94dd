#!/usr/bin/env python3
"""Writes paragraphs.json: how Pango breaks, orders and shapes paragraphs of several scripts, by its own program.

    tests/data/paragraphs.py > tests/data/paragraphs.json

Needs pango-view (Debian: pango1.0-tools; made with 1.50.12, HarfBuzz 6.0.0) and the fonts fonts-dejavu-core,
fonts-lohit-deva and fonts-tlwg-loma-ttf, and no other font of these scripts. Spaces are left out: Pango takes
them from the font of the letters before, browsers from the first font.
"""
import json
import pathlib
import subprocess
import tempfile

EM_PX = 18.8994140625  # 22 px from DejaVu Sans' lowest letter to its highest
NO_GLYPH = 268435455
PARAGRAPHS = [
    ("he", 300, "שלום עולם: press Enter או 1 (אחד) to continue, וזהו סוף הפסקה של הבדיקה."),
    ("ar", 300, "أنت مدعو للمشاركة في دراسة حول كيفية رؤية الناس للصور. اضغط Esc للاستراحة أو من 1 إلى 4 (مرة واحدة) ثم Enter."),
    ("hi", 300, "आपको यह बताना है कि चित्र में कौन सी वस्तु जोड़ी गई थी। क्षत्रिय और हिन्दी, 1 से 4 तक दबाएँ या Esc दबाएँ।"),
    ("th", 300, "ภาพแต่ละภาพมีวัตถุสามชิ้นและหนึ่งชิ้นถูกเพิ่มเข้ามาด้วยคอมพิวเตอร์ กด 1 ถึง 4 หรือ Esc เพื่อพักที่นี่"),
    ("en", 250, "Three discs are in the picture; Größe, façade, Ωμέγα and Привет stand beside them (press 1, 2 or 3)."),
    ("en", 260, "The participant said שלום עולם twice, and then مرحبا بالعالم once."),
]


def laid_out(folder, language, width_px, text):
    source, out = folder / "text", folder / "out.json"
    source.write_text(text, encoding="utf-8")
    command = ["pango-view", "--no-display", "--backend=ft2", f"--language={language}", "--no-auto-dir", "--dpi=72",
               "--hinting=none", "--subpixel-positions", f"--font=DejaVu Sans {EM_PX}px", f"--width={width_px}",
               f"--serialize-to={out}", f"--output={folder / 'out.pgm'}", str(source)]
    if language in ("ar", "he"):
        command.insert(1, "--rtl")
    subprocess.run(command, check=False, stderr=subprocess.DEVNULL)
    return json.loads(out.read_text())


def lines_of(layout):
    data = layout["text"].encode()
    for line in layout["output"]["lines"]:
        text = data[line["start-index"]:line["start-index"] + line["length"]].decode().rstrip(" ")
        glyphs = []
        for run in line["runs"]:
            family = run["font"]["description"].rsplit(" ", 1)[0]
            for glyph in run["glyphs"]:
                if glyph["glyph"] in (NO_GLYPH, 3):  # 3: the space of all three fonts
                    continue
                glyphs.append([family, glyph["glyph"]])
        yield {"text": text, "glyphs": glyphs}


def main():
    made = []
    with tempfile.TemporaryDirectory() as folder:
        for language, width_px, text in PARAGRAPHS:
            layout = laid_out(pathlib.Path(folder), language, width_px, text)
            made.append({"language": language, "text": text, "width_px": width_px, "lines": list(lines_of(layout))})
    rows = ",\n".join("  " + json.dumps(one, ensure_ascii=False) for one in made)
    print(f'{{"program": "pango-view 1.50.12", "size_px": 22, "paragraphs": [\n{rows}\n]}}')


if __name__ == "__main__":
    main()
