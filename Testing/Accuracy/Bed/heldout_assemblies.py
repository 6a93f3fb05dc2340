"""Assemblies that nothing is chosen by: to be looked at once a change is made, not before.

`HELD_OUT[name]()` makes one, as `assemblies.ASSEMBLIES` does.
"""

import numpy as np

from assemblies import half_space, of_materials
from primitives import box, cone, cylinder, prism, regular, sphere

FAR = 200.0  # cells: as good as infinite


def rod_through_box():
    """A rod that runs aslant through a box, and sticks out on both sides."""
    block = box(32, 28, 22)
    rod = cylinder(7, 44).rotate((18, 11, 0)).translate((2, -1, 0))
    return of_materials(block + rod, [block - rod, rod])


def parted_ball():
    """A ball cut by a plane, one half by a second plane, and a quarter of it by a third."""
    ball = sphere(19)
    one, two, three = (half_space(np.array(normal), FAR).translate(shift) for normal, shift in (
        ((0.2, 0.1, 1.0), (0, 0, 2)), ((1.0, 0.3, -0.2), (-1, 0, 0)), ((-0.3, 1.0, 0.4), (0, 1, 0))))
    upper, lower = ball ^ one, ball - one
    return of_materials(ball, [upper, lower ^ two, (lower - two) ^ three, lower - two - three])


def three_wedges():
    """A hexagonal bar of three wedges that meet in a line aslant to its faces."""
    bar = prism(regular(6, 17), 30)
    turns = 2 * np.pi * np.array([0.03, 0.36, 0.7])
    sides = [half_space(np.array([-np.sin(turn), np.cos(turn), 0.0]), FAR) for turn in turns]
    parts = [here - there for here, there in zip(sides, sides[1:] + sides[:1])]
    parts = [bar ^ part.rotate((12, -9, 0)).translate((1, -1, 0)) for part in parts]
    return of_materials(bar, parts)


def plug_in_disc():
    """A conical plug in a disc, flush with one of its faces."""
    disc = cylinder(21, 16)
    plug = cone(6, 13, 11).translate((3, 2, -3))
    return of_materials(disc, [disc - plug, plug])


HELD_OUT = {made.__name__: made
            for made in (rod_through_box, parted_ball, three_wedges, plug_in_disc)}
