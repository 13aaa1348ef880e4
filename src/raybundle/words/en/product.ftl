# $stage = "features"
product-gone = A product of the stage { $stage } is damaged or missing.
    .do = Run the same command again.
