"""Films by ffmpeg, and their captions. The pictures themselves are tested without it (tests/app/film_test.cpp)."""
from __future__ import annotations

import json
import os
import re

import pytest


def probed(folder, name: str) -> dict:
    said = folder.run("ffprobe", "-v", "error", "-count_frames", "-show_entries",
                      "stream=codec_name,width,height,r_frame_rate,nb_read_frames:format=duration", "-of", "json", name)
    data = json.loads(said)
    return {**data["streams"][0], **data["format"]}


def cues_of(text: str) -> list[tuple[float, float, str]]:
    assert text.startswith("WEBVTT\n\n")
    found = re.findall(r"^\d+\n(\d\d):(\d\d):([\d.]+) --> (\d\d):(\d\d):([\d.]+)\n((?:.+\n)+)", text, re.MULTILINE)
    return [(3600 * int(h) + 60 * int(m) + float(s), 3600 * int(i) + 60 * int(n) + float(t), words)
            for h, m, s, i, n, t, words in found]


@pytest.mark.parametrize("ending, codec", [("mp4", "h264"), ("webm", "vp9")])
def test_the_steps_with_captions(folder, ending, codec):
    folder.kinegraph("solve", "slider_crank", "-o", f"a.{ending}", "--height", "360")
    film = probed(folder, f"a.{ending}")
    assert (film["codec_name"], film["width"], film["height"]) == (codec, 640, 360)
    cues = cues_of((folder.path / "a.vtt").read_text())
    assert len(cues) > 5
    assert all(2 <= end - begin <= 15 for begin, end, _ in cues)
    assert all(one[1] <= other[0] for one, other in zip(cues, cues[1:]))
    assert cues[-1][1] == pytest.approx(float(film["duration"]), abs=0.25)
    assert folder.files("a*") and len(folder.files("*")) == 2


def test_a_picture_that_stands_is_once_in_a_gif(folder):
    folder.kinegraph("solve", "slider_crank", "-o", "a.gif", "--height", "360")
    folder.kinegraph("solve", "slider_crank", "-o", "slide.png", "--steps", "--slides", "--dpi", "20")
    stands = [float(time) for time in folder.run("ffprobe", "-v", "error", "-show_entries", "packet=duration_time",
                                                 "-of", "csv=p=0", "a.gif").split()]
    slides = [time for time in stands if time > 1]
    assert 5 < len(slides) <= len(folder.files("slide*"))
    # Two slides that look alike stand as one picture. Before a slide its lines grow in four pictures at most.
    assert all(time <= 30 for time in slides), stands
    assert 5 < len(stands) - len(slides) <= 4 * len(slides)


def test_a_motion(folder):
    folder.kinegraph("sweep", "four_bar", "-o", "a.mp4", "-o", "a.gif", "--frames", "12", "--height", "360", "--trace",
                     "B")
    for name, frames in (("a.mp4", "12"), ("a.gif", "12")):
        film = probed(folder, name)
        assert (film["width"], film["height"], film["nb_read_frames"]) == (640, 360, frames)
    assert len(folder.files("*")) == 2


def test_a_picture_of_the_film_is_the_slide(folder):
    folder.kinegraph("solve", "slider_crank", "-o", "a.mp4", "--height", "720", "--captions", "burnt")
    folder.kinegraph("solve", "slider_crank", "-o", "slide.png", "--steps", "--slides", "--dpi", "160")
    # When the lines of the first slide are drawn.
    folder.run("ffmpeg", "-v", "error", "-ss", "1", "-i", "a.mp4", "-frames:v", "1", "frame.png")
    likeness = folder.run("ffmpeg", "-hide_banner", "-i", "frame.png", "-i", "slide.png", "-lavfi",
                          "[0:v]format=gray[a];[1:v]format=gray[b];[a][b]ssim=stats_file=-", "-f", "null", "-")
    assert float(re.search(r"All:([\d.]+)", likeness).group(1)) > 0.98
    assert not (folder.path / "a.vtt").exists()


def test_without_ffmpeg(folder):
    said = folder.kinegraph("solve", "slider_crank", "-o", "a.mp4", status=4, env={**os.environ, "PATH": "/nowhere"})
    assert said == "kinegraph: a film is made by ffmpeg, which is missing: install the Debian package ffmpeg\n"
    assert not list(folder.path.iterdir())
