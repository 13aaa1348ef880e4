photographs-targets = Cibles de la photographie { $photograph } :
