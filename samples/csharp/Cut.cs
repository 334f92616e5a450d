// A cut and its surface from C#:  mono cut.exe JOB.json DIR
//
// What a Rhino or Grasshopper component would do: read a job, simulate it, take the wire's nodes as points, loft the
// surface, find closest points, write STEP. Point3d stands for Rhino's own struct: three doubles, so that arrays of it pass
// as they are. Build:  mcs -unsafe Cut.cs Native.cs -out:cut.exe
using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;

public struct Point3d
{
    public double X, Y, Z;
}

public class WirecutException : Exception
{
    public readonly wcut_status Status;

    public WirecutException(wcut_status status, string text) : base(text) { Status = status; }
}

public static unsafe class Cut
{
    // the text of a failure: place and expectation
    static void Check(wcut_status status, wcut_error* error)
    {
        if (status == wcut_status.WCUT_OK) return;
        string text = error != null && error->text[0] != 0 ? Marshal.PtrToStringAnsi((IntPtr)error->text)
                                                            : Marshal.PtrToStringAnsi((IntPtr)Native.wcut_status_text(status));
        throw new WirecutException(status, text);
    }

    static byte[] Text(string text) { return Encoding.UTF8.GetBytes(text + "\0"); }

    static void Run(string jobFile, string folder)
    {
        wcut_error error = new wcut_error();
        wcut_job* job;
        fixed (byte* path = Text(jobFile)) Check(Native.wcut_job_read(path, &job, &error), &error);

        // simulate: the history owns stations x nodes points
        void* setup;
        wcut_history* history;
        Check(Native.wcut_setup_create(job, null, &setup, &error), &error);
        Check(Native.wcut_setup_run(setup, IntPtr.Zero, null, &history, &error), &error);
        int count = history->stations * history->nodes;
        Console.WriteLine("{0} stations of {1} nodes", history->stations, history->nodes);

        // an array of Point3d goes in as it is
        Point3d[] nodes = new Point3d[count];
        fixed (Point3d* to = nodes) Buffer.MemoryCopy(history->position, to, count * sizeof(Point3d), count * sizeof(Point3d));
        wcut_surface* surface;
        fixed (Point3d* from = nodes)
            Check(Native.wcut_surface_loft(history->stations, history->nodes, (wcut_vec3*)from, 1e-3, &surface, null, null), null);

        // closest points of the nodes: they lie on the surface
        void* projection;
        wcut_foot[] foot = new wcut_foot[count];
        Check(Native.wcut_projection_create(surface, &projection), null);
        fixed (Point3d* query = nodes) fixed (wcut_foot* to = foot)
            Check(Native.wcut_projection_locate(projection, count, (wcut_vec3*)query, 1, to), null);
        double far = 0;
        foreach (wcut_foot f in foot) far = Math.Max(far, f.distance);
        Console.WriteLine("nodes are at most {0:e1} mm from the surface", far);

        // write the exact surface
        fixed (byte* name = Text("surface"), path = Text(Path.Combine(folder, "surface.step")))
        {
            wcut_shape shape = new wcut_shape();
            shape.name = name;
            shape.surface = surface;
            Check(Native.wcut_step_write(1, &shape, wcut_step_schema.WCUT_STEP_SCHEMA_AP214, path, &error), &error);
        }
        Native.wcut_projection_destroy(projection);
        Native.wcut_surface_destroy(surface);
        Native.wcut_history_destroy(history);
        Native.wcut_setup_destroy(setup);
        Native.wcut_job_destroy(job);
        if (far > 1e-6) throw new WirecutException(wcut_status.WCUT_INTERNAL, "nodes are not on their surface");
    }

    public static int Main(string[] arguments)
    {
        if (arguments.Length != 2)
        {
            Console.Error.WriteLine("usage: cut.exe JOB.json DIR");
            return 2;
        }
        try
        {
            Directory.CreateDirectory(arguments[1]);
            Run(arguments[0], arguments[1]);
            return 0;
        }
        catch (WirecutException failure)
        {
            Console.Error.WriteLine(failure.Message);
            return 1;
        }
    }
}
