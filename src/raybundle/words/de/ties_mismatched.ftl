ties_mismatched = { $pairs } { $pairs ->
        [one] Paar verworfener Verknüpfungspunkte wurde
       *[other] Paare verworfener Verknüpfungspunkte wurden
     } miteinander verwechselt: { $ids }.
