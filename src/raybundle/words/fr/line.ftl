line-too_few_words = Mots de cette ligne : { $n } ; nécessaires : { $needed }, à la fin { $columns }.

line-unprintable = La ligne contient des caractères non imprimables.

line-ends_early = La ligne se termine trop tôt.

line-words_left = Mots en trop à la fin de la ligne : { $n }.

line-too_few_cells = Colonnes de cette ligne : { $n } ; nécessaires : { $needed }.
