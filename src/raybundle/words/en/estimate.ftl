# $known = ["a0", "b0"]
estimate-no_list = The parameters to be estimated must be listed.
    .do = Give a list of { LIST($known, most: 20) }.

# $value = "'all'"
# $known = ["c", "x0", "y0"]
estimate-neither_auto_nor_list = { $value } is neither "auto" nor a list of parameters.
    .do = Give "auto", or a list of { LIST($known, most: 20) }.
