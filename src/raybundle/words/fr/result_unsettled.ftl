result_unsettled = Le résultat utilisé { $name } a { $n } défaut(s).
