# %%
from pathlib import Path

import raybundle as rb
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.planning.simulate import Survey, simulate
from raybundle.workflows.adjust import adjust
from raybundle.workflows.within_memory import within_memory

block = simulate(aerial_scene(AerialStrips(strips=2, images_per_strip=4, points_per_image=60)), Survey()).observed
with within_memory(block, Path("result"), memory_gb=0.1) as (kept, room):
    result = adjust(kept)
assert room.parts >= 1
assert abs(result.sigma0 / rb.adjust(block).sigma0 - 1) < 1e-9
