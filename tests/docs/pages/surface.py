# %%
from raybundle.surfaces.files.heights import read_heights

model, file = read_heights("facade-project/surface")
h = model.heights
even = model.known & (h.step < 0.0005) & (h.local < 0.005)
mean, whole = model.sum_of(even / even.sum()), model.sum_of(model.known / model.known.sum())
assert mean.local < mean.orientation
assert whole.local > whole.orientation
