number-not_finite = { $entry } vaut { $value }, ce n'est pas un nombre fini.

number-too_small = { $entry } vaut { $value }.

number-below = { $entry } vaut { $value }.

number-too_large = { $entry } vaut { $value }.
