result-not_a_folder = Un fichier de ce nom existe ; le résultat est un dossier.

result-other_folder = Ce dossier n'est pas un résultat et n'est pas écrasé.

result-foreign_files = Le dossier contient { $n } fichier(s) non écrit(s) par une compensation : { LIST($names, most: 3) }.

result-no_result = Ce n'est pas un dossier de résultat : result.json manque.

result-not_of_adjustment = Le fichier n'est pas le result.json d'une compensation.

result-unknown_id = { $id } n'est pas dans { $table } ; le résultat est endommagé.

result-no_folder = Il n'y a pas de tel dossier.

result-none_in_folder = Le dossier n'a ni result.json, ni block.toml, ni project.db.
