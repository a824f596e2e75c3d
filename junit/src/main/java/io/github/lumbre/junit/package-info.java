/**
 * Pictures in JUnit 5 tests: golden pictures, and scenes that are rendered for a test.
 *
 * <p>{@link io.github.lumbre.junit.GoldenPictures#assertThatPicture} compares a picture with one
 * that is stored beside the tests; {@link io.github.lumbre.junit.RenderedScene} passes the picture
 * of a scene or model to a test. System properties say where golden pictures are and whether to
 * store them; see {@link io.github.lumbre.junit.GoldenPictures}.
 */
package io.github.lumbre.junit;
