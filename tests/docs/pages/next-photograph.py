# %%
import raybundle as rb

result = rb.adjust(rb.read_block("ring/block"))
plan = rb.plan_next(result, photographs=2, aim="mean", candidates=300)
for name, chosen in zip(plan.names, plan.proposals):
    print(name, chosen.before.value, "->", chosen.after.value)
assert plan.proposals[-1].after.value < plan.proposals[0].before.value
