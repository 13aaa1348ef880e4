features-unknown = La méthode d'extraction { $name } est inconnue.

features-not_installed = La méthode d'extraction { $name } nécessite { $packages }.
