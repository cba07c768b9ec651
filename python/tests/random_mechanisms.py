"""Random mechanisms: a crank, dyads on it, masses and a force. Many cannot be assembled; these are refused, which is
compared, too."""

import random

from kinegraph import Mechanism, circle


def decimal(source: random.Random, least: int, most: int) -> float:
    return source.randint(10 * least, 10 * most) / 10


def add_dyad(built: Mechanism, source: random.Random, index: int, carriers: list[tuple[str, int]]) -> None:
    """Two bodies more: a rocker on the frame, or a slider in it, joined by a coupler with a point of the chain."""
    point, body = source.choice(carriers)
    coupler, follower, pin = 2 * index + 3, 2 * index + 4, f"P{index}"
    built.revolute(point, body, coupler)
    if source.random() < 0.6:
        built.point(f"F{index}", decimal(source, 60, 200), decimal(source, -60, 60))
        built.point(pin, meet=[circle(point, decimal(source, 60, 200)), circle(f"F{index}", decimal(source, 40, 160))],
                    side=source.choice(["left", "right"]))
        built.link(follower, f"F{index}", pin).revolute(f"F{index}", 1, follower)
    else:
        height = decimal(source, -30, 30)
        built.point(pin, meet=[circle(point, decimal(source, 80, 200)), {"line": [0, height], "angle": 0}],
                    side="ahead")
        built.link(follower, pin).prismatic(pin, follower, 1, along=0)
    built.link(coupler, point, pin).revolute(pin, coupler, follower)
    carriers.append((pin, follower))


def random_mechanism(seed: int) -> Mechanism:
    """The same mechanism for the same seed."""
    source = random.Random(seed)
    built = (Mechanism().units(length="mm").frame(1).point("O", 0, 0)
             .point("A", decimal(source, 10, 50), decimal(source, -50, 50)).link(2, "O", "A").revolute("O", 1, 2)
             .driver(body=2, omega=decimal(source, -20, 20), alpha=decimal(source, -5, 5)))
    carriers = [("A", 2)]
    for index in range(source.randint(1, 3)):
        add_dyad(built, source, index, carriers)
    last, follower = carriers[-1]
    if source.random() < 0.5:
        built.load(force="F", body=follower, at=last, value=[decimal(source, -90, 90), decimal(source, -90, 90)])
        built.effort(couple="M", body=2)
    return built
