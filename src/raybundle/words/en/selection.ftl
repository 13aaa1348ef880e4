# $quantity = "w"
# $limit = 5.0
selection-nothing_beyond = No image observation is beyond { $limit } in { $quantity }.
    .do = Give another limit.

# $quantity = "'v'"
# $known = ["w", "sigma"]
selection-unknown_quantity = Quantity { $quantity } is unknown.
    .do = Use one of { LIST($known, most: 9) }.
