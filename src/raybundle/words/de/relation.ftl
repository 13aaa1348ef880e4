relation-no_list = { $value } ist keine Liste von Beziehungen.
    .do = Eine Liste von Tabellen mit name, terms, observed und sigma angeben.

relation-incomplete_entry = Eintrag { $number } ist keine Beziehung.
    .do = name, terms (Symbol = Faktor), observed und sigma angeben.
