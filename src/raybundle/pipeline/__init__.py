"""Stages, tasks and where their products are kept: what is done is known by its content, never done twice.

keys        what a product depends on, as a hash
store       products of tasks and stages in files, whole or not at all
project     a project folder: store, small products and records of stages in SQLite, one run at a time
tasks       what another process can do by itself: a function by name, plain options, keys of products
executors   who does tasks: threads of this process, or processes of their own
stage       a step of a workflow as a value, and the run that gives it products, executors and progress
"""
