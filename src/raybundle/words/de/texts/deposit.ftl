deposit-written = Gepackt: { $n } Dateien, { NUM($mb, digits: 3) } MB.
