# $detail = "Expecting value"
# $character = 12
# $cut = false
json-invalid = This is not valid JSON: { $detail } (character { $character }).
    .do = { $cut ->
        [yes] Get the file again: its end is missing
       *[no] Correct this line
     }.

# $name = "'focal'"
json-key_twice = Key { $name } occurs twice in one object.
    .do = Delete one.

# $value = "NaN"
json-not_finite = { $value } is not a number in JSON.
    .do = Give a finite number, or null.
