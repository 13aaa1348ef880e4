# $value = "'a'"
relation-no_list = { $value } is not a list of relations.
    .do = Give a list of tables with name, terms, observed and sigma.

# $number = 2
relation-incomplete_entry = Entry { $number } is not a relation.
    .do = Give name, terms (symbol = factor), observed and sigma.
