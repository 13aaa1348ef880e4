# $stage = "features"
product-gone = A product of the stage { $stage } is damaged or missing.
    .do = Run the same command again.

# $command = "raybundle heights volume"
product-needs_heights = { $command } requires a surface with heights.
    .why = There is no heights.tif in this folder.
    .do = Make the surface with { OPTION("dsm") } first.
