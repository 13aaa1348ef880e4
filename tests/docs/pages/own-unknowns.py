# %%
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from raybundle import adjust, transform_block
from raybundle.adjustment.observation_contract import partials_off
from raybundle.errors import InputError
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.numerics.transform import SimilarityTransform
from raybundle.observations import ResidualKind, Scope, Table, cells, length
from raybundle.planning.simulate import Survey, simulate

rng = np.random.default_rng(5)
turned = SimilarityTransform(rotation=rotation_from_angles(np.array([0.0, 0.0, 0.3])))
