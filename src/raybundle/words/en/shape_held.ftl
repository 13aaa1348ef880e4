# $camera = "d5100"
# $symbol = "A"
# $sigma = 0.0004
# $found = 0.0001
# $limit = 0.0001
# $ids = ["d5100", "A"]
shape_held = Camera { $camera }: { $symbol } was held; the photographs determine it only to { NUM($sigma, digits: 1) }.
    .why = The best fit is { NUM($found, digits: 2) }, and sensors have less than { NUM($limit, digits: 1) }.
