no_redundancy = La compensation n'a aucune redondance.
