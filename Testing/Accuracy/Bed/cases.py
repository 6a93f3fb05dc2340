"""Names to solids, truths and sampled meshes."""

from functools import lru_cache

import cache
import random_parts
import sampling
from solids import SOLIDS
from truth import Truth

SETS = {
    "designed": list(SOLIDS),
    "random": [f"random{seed}" for seed in random_parts.DEVELOPMENT_SEEDS],
    "heldout": [f"heldout{seed}" for seed in random_parts.HELD_OUT_SEEDS],
}


def names_of(words):
    """Solids by name, or by the name of a set; 'all' is the designed and the development ones."""
    names = []
    for word in words:
        if word == "all":
            names += SETS["designed"] + SETS["random"]
        elif word in SETS:
            names += SETS[word]
        elif any(word in members for members in SETS.values()):
            names.append(word)
        else:
            raise ValueError(f"{word}: no such solid; there are {', '.join(SETS)}, all, "
                             f"and {', '.join(SOLIDS)}")
    return list(dict.fromkeys(names))


@lru_cache(maxsize=4)
def truth_of(name):
    """The truth of a solid; random parts go by random<seed> and heldout<seed>."""
    if name in SOLIDS:
        return Truth(SOLIDS[name]())
    return Truth(random_parts.random_part(int(name.removeprefix("random").removeprefix("heldout"))))


def input_mesh(folder, name, sampling_name):
    """The sampled mesh of a solid, kept in the folder beside the truth's files."""
    truth = truth_of(name)
    cache.export_truth(folder / name, truth)
    return cache.cached_mesh(folder / name / f"{sampling_name}.vtk", cache.key_of(truth),
                             lambda: sampling.sampled(truth, sampling_name))
