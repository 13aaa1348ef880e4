report-unknown_language = Il n'y a pas de rapport dans la langue { $language }.

report-no_table = Le résultat n'a pas de tableau { $name }.
