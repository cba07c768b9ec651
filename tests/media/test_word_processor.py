"""A picture with text for word processors in LibreOffice: its letters stay letters, in their places."""
from __future__ import annotations

from conftest import PROGRAM


def test_libreoffice_keeps_the_letters(folder):
    folder.kinegraph("solve", "four_bar", "-o", "a.svg", "-o", "ours.png", "--text", "office", "--dpi", "100")
    folder.run("soffice", "--headless", f"-env:UserInstallation=file://{folder.path}/profile", "--convert-to", "pdf",
               "a.svg")
    words = " ".join(folder.run("pdftotext", "-layout", "a.pdf", "-").split())
    for sentence in ("Velocity polygon", "Through the known ends draw the lines", "magnitude", "Instant centres"):
        assert sentence in words
    assert "LiberationSerif-Italic" in folder.run("pdffonts", "a.pdf")
    folder.run("pdftoppm", "-png", "-singlefile", "-scale-to-x", "1170", "-scale-to-y", "827", "a.pdf", "theirs")
    # Other letters of the same widths in the same places.
    folder.run(str(PROGRAM), "diff", "ours.png", "theirs.png", "--threshold", "5%", "--tolerance", "0.2")
