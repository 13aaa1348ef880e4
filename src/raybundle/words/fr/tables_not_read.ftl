tables_not_read = Des tableaux du dossier du bloc n'ont pas été lus : { LIST($names, most: 3) }.
