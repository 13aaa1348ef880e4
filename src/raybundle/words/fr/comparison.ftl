comparison-path_taken = Un fichier qui n'est pas une comparaison porte déjà ce nom.
