# $verb = "'draw'"
# $known = ["put", "move"]
action-unknown_verb = Verb { $verb } is unknown.
    .do = Use one of { LIST($known, most: 30) }.

# $verb = "put"
# $name = "'z'"
# $known = ["image", "point"]
action-unknown_argument = { $verb }: argument { $name } is unknown.
    .do = Use { LIST($known, most: 30) }.

# $verb = "put"
# $detail = "Expected `float`, got `str`"
action-arguments = { $verb }: the arguments are invalid ({ $detail }).
    .do = Give them as documented.
