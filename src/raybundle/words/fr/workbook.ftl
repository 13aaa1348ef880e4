workbook-no_table = Aucune table avec des lignes pour le classeur.

workbook-too_many_rows = La table a plus de { $most } lignes, la limite d'une feuille de calcul.

workbook-unknown_table = Il n'y a pas de table { $table }.
