select-mask = Un masque de { $n } valeurs a été donné pour { $count } { $name }.

select-twice = La sélection de { $name } contient un élément deux fois.
