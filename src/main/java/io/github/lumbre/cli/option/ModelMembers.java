package io.github.lumbre.cli.option;

import java.util.function.Consumer;
import picocli.CommandLine.Model.ArgGroupSpec;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.IGetter;
import picocli.CommandLine.Model.IScope;
import picocli.CommandLine.Model.ISetter;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/**
 * The fields of one object that flags and arguments set, for {@link CommandModel}.
 *
 * @param <T> the annotated class
 */
public final class ModelMembers<T> {
  private final CommandModel<T> model;
  private final T object;
  private final Consumer<ArgSpec> receiver;
  private final IScope scope;

  ModelMembers(CommandModel<T> model, T object, Consumer<ArgSpec> receiver) {
    this.model = model;
    this.object = object;
    this.receiver = receiver;
    scope = new Owner(object);
  }

  /** Adds a flag or an argument. */
  public void add(ArgSpec arg) {
    receiver.accept(arg);
  }

  /** Adds a group of flags that exclude each other. */
  public <G> void addGroup(CommandSpec spec, G group, CommandModel<G> groupModel) {
    ArgGroupSpec.Builder builder = ArgGroupSpec.builder();
    groupModel.describe(group, new ModelMembers<>(groupModel, group, builder::addArg), spec);
    spec.addArgGroup(builder.build());
  }

  /** Returns the beginning of a flag that sets a field. */
  public OptionSpec.Builder option(int field, String... names) {
    Field bound = new Field(field);
    return OptionSpec.builder(names)
        .getter(bound)
        .setter(bound)
        .scope(scope)
        .initialValue(bound.get());
  }

  /** Returns the beginning of an argument that sets a field. */
  public PositionalParamSpec.Builder argument(int field) {
    Field bound = new Field(field);
    return PositionalParamSpec.builder()
        .getter(bound)
        .setter(bound)
        .scope(scope)
        .initialValue(bound.get());
  }

  /** A field of the object. */
  private final class Field implements IGetter, ISetter {
    private final int number;

    Field(int number) {
      this.number = number;
    }

    @Override
    @SuppressWarnings("unchecked") // Only picocli calls this, with the type of the field.
    public <V> V get() {
      return (V) model.get(object, number);
    }

    @Override
    public <V> V set(V value) {
      model.set(object, number, value);
      return null;
    }
  }

  /** The object, which picocli never exchanges. */
  private static final class Owner implements IScope {
    private final Object object;

    Owner(Object object) {
      this.object = object;
    }

    @Override
    @SuppressWarnings("unchecked") // picocli only asks whether there is an object.
    public <V> V get() {
      return (V) object;
    }

    @Override
    public <V> V set(V value) {
      throw new UnsupportedOperationException("The object of generated models is final.");
    }
  }
}
