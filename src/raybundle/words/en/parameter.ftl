# $name = "'K9'"
# $model = "brown"
# $known = ["c", "x0", "y0"]
parameter-unknown = { $name } is not a parameter of { $model }.
    .do = Use one of { LIST($known, most: 20) }.

# $name = "K1"
parameter-twice = Parameter { $name } occurs twice.
    .do = Delete one.

# $value = "'K9'"
# $known = ["c", "x0", "y0"]
parameter-no_list = { $value } is not a list of parameters.
    .do = Give a list of { LIST($known, most: 20) }.

# $name = "K1"
# $sigma = 0.0
parameter-sigma_not_positive = The standard deviation of { $name } is { $sigma }.
    .do = Give a value above 0, or remove { $name } from estimate to fix it.

# $name = "x0"
parameter-sigma_of_fixed = { $name } has a standard deviation, but is fixed.
    .do = Add it to estimate, or delete its standard deviation.

# $way = "free"
# $camera = "d3"
# $known = ["d5100", "d7200"]
parameter-unknown_camera = { $way ->
        [free] { OPTION("free") }
       *[hold] { OPTION("hold") }
     }: camera { $camera } is not in the block.
    .do = Use one of these cameras: { $known }.

# $camera = "d5100"
# $symbol = "K1"
parameter-free_and_held = Parameter { $symbol } of camera { $camera } is selected as free and as held.
    .do = Remove it from { OPTION("free") } or from { OPTION("hold") }.

# $way = "free"
# $camera = "d5100"
# $symbol = "K9"
# $known = ["c", "x0", "y0"]
parameter-not_of_camera = { $way ->
        [free] { OPTION("free") }
       *[hold] { OPTION("hold") }
     }: camera { $camera } has no parameter { $symbol }.
    .do = Use one of { LIST($known, most: 20) }.
