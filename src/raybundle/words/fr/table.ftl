table-more_errors = Il y a d'autres erreurs ; le reste du fichier n'a pas été lu.
