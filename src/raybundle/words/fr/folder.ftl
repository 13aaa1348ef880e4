folder-exists = Le dossier existe déjà et n'est pas vide.

folder-url = Le chemin commence comme une URL ({ $scheme }//).

folder-parent_is_a_file = { $parent } n'est pas un dossier ; rien ne peut y être écrit.

folder-special_file = Ce n'est ni un fichier ni un dossier.

folder-is_a_file = Un fichier porte ce nom ; il faut un dossier.

folder-file_missing = Le dossier n'a pas de fichier { $name }.

folder-several_files = Le dossier a { $n } fichiers { $name } ; il en faut un.

folder-not_listed = Le dossier ne peut être listé ({ $detail }).

folder-missing = Le dossier de ce fichier n'existe pas.

folder-other_block = Le dossier contient un autre bloc, qui n'est pas écrasé.

folder-missing_itself = Ce dossier n'existe pas.
