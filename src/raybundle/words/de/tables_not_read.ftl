tables_not_read = Tabellen im Blockordner wurden nicht gelesen: { LIST($names, most: 3) }.
    .why = Beobachtungen darin gehen nicht ein.
    .do = Einen Tabellennamen des Blockformats verwenden oder in Python mit der importierten Beobachtungsart ausgleichen.
