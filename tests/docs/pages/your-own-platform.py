# %%
from dataclasses import replace

import numpy as np

from raybundle import adjust
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.planning.simulate import Survey, measured, simulate

rng = np.random.default_rng(5)
