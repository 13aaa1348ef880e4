comparison-path_taken = Un fichier qui n'est pas une comparaison porte déjà ce nom.

comparison-one_result = Il n'y a pas de résultat antérieur à comparer.
