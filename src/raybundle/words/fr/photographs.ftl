photographs-targets = Cibles de la photographie { $photograph } :

photographs-not_usable = { $n } fichiers ne sont pas utilisés : { $names }.
