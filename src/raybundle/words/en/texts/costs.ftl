# $n = 10000
# $megapixels = 20.0
# $cpu = "120 h"
# $wall = "9 h"
# $disk = "240 GB"
costs-estimated = Estimate for { $n } photographs of { $megapixels } MP: CPU { $cpu }, wall time { $wall }, disk { $disk }.

# $what = "memory of the driver"
# $needed = "3 GB"
# $given = "8 GB"
costs-tightest = No limit is exceeded; the tightest is { $what }: { $needed } of { $given }.

# $points = 1200000
# $overlap = 12.5
# $iterations = 8
costs-assumed = Assumed: { $points } image points, { $overlap } photographs of a place, { $iterations } iterations.

# $stage = "features"
# $share = 0.6
# $by = "megapixels"
costs-dominant = Largest part: { $stage }, { PERCENT($share) } % of the CPU time (depends on { $by }).

# $n = 12000
costs-largest_matrix = Reduction up: the largest matrix of a part has { $n } unknowns.

costs-not_included = Not included: the surface, and the further adjustments in which orient rejects blunders.

# $processor = "AMD EPYC"
# $date = "2026-05-01"
costs-measured = Measured on { $processor }, { $date }.

# $workers = 16
# $share = 0.2
costs-idle = { $workers } workers: in { PERCENT($share) } % of the wall time some have no task.

# $size = "64 GB"
costs-memory_remedy = Use a machine of { $size }, fewer points ({ OPTION("feature_count", "N") }), or parts joined by raybundle merge.

costs-precision_remedy = { OPTION("quick", "True") } of orient leaves precision out: several times less precise.

costs-disk_remedy = Put the products on another disk or in an object store ({ OPTION("store", "URL") } of orient).
