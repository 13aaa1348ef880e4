merge-no_block = blocks[{ $entry }] est de type { $kind }, pas un bloc.

merge-prefer_no_mapping = prefer = { $value } n'est pas une table de correspondance.

merge-prefer_unknown = prefer : l'entrée { $name } = { $block } n'est pas valable.

merge-no_blocks = Il n'y a pas de blocs à fusionner.

merge-contradiction = { $name } vaut { $value } dans le bloc { $first } ({ $block }), { $other } dans le bloc { $second } ({ $other_block }).

merge-do_not_fit = Les blocs ne vont pas ensemble : { $name }, { $entry }.
