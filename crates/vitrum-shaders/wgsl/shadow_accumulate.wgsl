struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_7 {
member: array<u32>,
}
struct type_8 {
member: type_2,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: type_4,
member_12: type_4,
member_13: f32,
}
struct type_9 {
member: type_8,
}
struct type_12 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(2)
var<storage, read_write> global_1: type_12;
@group(0) @binding(0)
var<storage> global_2: type_9;
@group(0) @binding(1)
var<storage> global_3: type_7;
fn function_() {
var phi_142_: i32;
var phi_145_: i32;
var phi_143_: i32;
var phi_146_: i32;
var local: i32;
var local_1: i32;
var phi_182_: i32;
var phi_185_: type_2;
var local_2: i32;
var local_3: i32;
var phi_255_: u32;
var phi_270_: u32;
var phi_276_: u32;
var phi_388_: type_2;
var local_4: i32;
var phi_451_: u32;
var phi_466_: u32;
var phi_472_: u32;
var phi_584_: type_2;
var phi_183_: i32;
var phi_186_: type_2;
let _e42 = global;
let _e49 = global_2.member.member;
if (_e42.x < _e49.member) {
if (_e42.y < _e49.member_1) {
let _e60 = global_2.member.member.member;
let _e62 = ((_e42.y * _e60) + _e42.x);
let _e65 = global_2.member.member_1;
if (_e62 < _e65) {
let _e69 = global_2.member.member_3;
let _e72 = global_2.member.member_4;
let _e74 = bitcast<i32>((_e69 * _e72));
phi_142_ = bitcast<i32>(_e62);
phi_145_ = 0i;
loop {
let _e77 = phi_142_;
let _e79 = phi_145_;
local = _e79;
local_1 = _e77;
local_2 = _e77;
local_3 = _e79;
local_4 = _e79;
let _e80 = (_e77 >= _e74);
if _e80 {
phi_143_ = (_e77 - _e74);
phi_146_ = (_e79 + 1i);
} else {
phi_143_ = i32();
phi_146_ = i32();
}
let _e84 = phi_143_;
let _e86 = phi_146_;
continue;
continuing {
phi_142_ = _e84;
phi_145_ = _e86;
break if !(_e80);
}
}
let _e90 = global_2.member.member_2;
let _e91 = bitcast<i32>(_e90);
let _e95 = bitcast<i32>(((_e90 + 2u) >> bitcast<u32>(1i)));
let _e98 = global_2.member.member_7;
let _e101 = local;
let _e105 = global_2.member.member_5;
let _e110 = global_2.member.member_6;
let _e115 = local_1;
phi_182_ = 0i;
phi_185_ = type_2(0u, 0u, 65535u);
loop {
let _e120 = phi_182_;
let _e122 = phi_185_;
let _e123 = (_e120 < _e95);
if _e123 {
let _e124 = (2i * _e120);
let _e127 = local_2;
let _e128 = (_e127 * _e91);
let _e133 = global_2.member.member_8;
let _e134 = bitcast<i32>(_e133);
let _e138 = local_3;
let _e140 = ((((_e128 + _e124) * _e134) + _e138) * 2i);
let _e142 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e144 = select(_e142, _e140, (_e140 < _e142));
let _e150 = global_3.member[bitcast<u32>(select(0i, _e144, (_e144 > 0i)))];
let _e151 = (_e140 + 1i);
let _e153 = select(_e142, _e151, (_e151 < _e142));
let _e159 = global_3.member[bitcast<u32>(select(0i, _e153, (_e153 > 0i)))];
if ((_e124 < _e91) && ((_e150 | _e159) != 0u)) {
let _e164 = (_e49.member_2 == 1u);
if _e164 {
let _e167 = global_2.member.member_10;
phi_255_ = _e167;
} else {
phi_255_ = _e150;
}
let _e169 = phi_255_;
let _e171 = (_e122.member + _e169);
let _e175 = ((_e122.member_1 + select(_e159, 0u, _e164)) + select(0u, 1u, (_e171 < _e122.member)));
let _e178 = ((_e175 >> bitcast<u32>(31i)) != 0u);
if _e178 {
phi_270_ = (~(_e171) + 1u);
} else {
phi_270_ = _e171;
}
let _e184 = phi_270_;
if _e178 {
phi_276_ = (~(_e175) + select(0u, 1u, (_e171 == 0u)));
} else {
phi_276_ = _e175;
}
let _e188 = phi_276_;
let _e210 = ((((f32(bitcast<i32>(((_e188 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e188 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e184 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e184 & 65535u)))));
let _e218 = -((select(_e210, -(bitcast<f32>((bitcast<u32>(_e210) & 2147483647u))), _e178) * (1f / 16777216f)));
let _e220 = select(-87f, _e218, (_e218 > -87f));
let _e222 = select(88f, _e220, (_e220 < 88f));
let _e224 = ((_e222 * 1.442695f) + 0.5f);
let _e226 = select(-127f, _e224, (_e224 > -127f));
let _e228 = select(128f, _e226, (_e226 < 128f));
let _e235 = select(0i, select(select(i32(_e228), i32(-2147483648), (_e228 < -2147483600f)), 2147483647i, (_e228 > 2147483500f)), (_e228 == _e228));
let _e239 = (_e235 - select(0i, 1i, (_e228 < f32(_e235))));
let _e240 = f32(_e239);
let _e244 = ((_e222 - (_e240 * 0.6933594f)) - (_e240 * -2.1219444e-4f));
let _e266 = ((((1f + (_e244 * (1f + (_e244 * (0.5f + (_e244 * (0.16666667f + (_e244 * (0.041666668f + (_e244 * (0.008333334f + (_e244 * (0.001388889f + (_e244 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e239 + 127i)) << bitcast<u32>(23i)))) * 65535f) + 0.5f);
let _e268 = select(0f, _e266, (_e266 > 0f));
let _e270 = select(65535f, _e268, (_e268 < 65535f));
let _e277 = select(0i, select(select(i32(_e270), i32(-2147483648), (_e270 < -2147483600f)), 2147483647i, (_e270 > 2147483500f)), (_e270 == _e270));
phi_388_ = type_2(_e171, _e175, bitcast<u32>((_e277 - select(0i, 1i, (_e270 < f32(_e277))))));
} else {
phi_388_ = _e122;
}
let _e285 = phi_388_;
let _e287 = (_e124 + 1i);
let _e293 = local_4;
let _e295 = ((((_e128 + _e287) * _e134) + _e293) * 2i);
let _e297 = select(_e142, _e295, (_e295 < _e142));
let _e303 = global_3.member[bitcast<u32>(select(0i, _e297, (_e297 > 0i)))];
let _e304 = (_e295 + 1i);
let _e306 = select(_e142, _e304, (_e304 < _e142));
let _e312 = global_3.member[bitcast<u32>(select(0i, _e306, (_e306 > 0i)))];
if ((_e287 < _e91) && ((_e303 | _e312) != 0u)) {
let _e317 = (_e49.member_2 == 1u);
if _e317 {
let _e320 = global_2.member.member_10;
phi_451_ = _e320;
} else {
phi_451_ = _e303;
}
let _e322 = phi_451_;
let _e324 = (_e285.member + _e322);
let _e328 = ((_e285.member_1 + select(_e312, 0u, _e317)) + select(0u, 1u, (_e324 < _e285.member)));
let _e331 = ((_e328 >> bitcast<u32>(31i)) != 0u);
if _e331 {
phi_466_ = (~(_e324) + 1u);
} else {
phi_466_ = _e324;
}
let _e337 = phi_466_;
if _e331 {
phi_472_ = (~(_e328) + select(0u, 1u, (_e324 == 0u)));
} else {
phi_472_ = _e328;
}
let _e341 = phi_472_;
let _e363 = ((((f32(bitcast<i32>(((_e341 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e341 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e337 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e337 & 65535u)))));
let _e371 = -((select(_e363, -(bitcast<f32>((bitcast<u32>(_e363) & 2147483647u))), _e331) * (1f / 16777216f)));
let _e373 = select(-87f, _e371, (_e371 > -87f));
let _e375 = select(88f, _e373, (_e373 < 88f));
let _e377 = ((_e375 * 1.442695f) + 0.5f);
let _e379 = select(-127f, _e377, (_e377 > -127f));
let _e381 = select(128f, _e379, (_e379 < 128f));
let _e388 = select(0i, select(select(i32(_e381), i32(-2147483648), (_e381 < -2147483600f)), 2147483647i, (_e381 > 2147483500f)), (_e381 == _e381));
let _e392 = (_e388 - select(0i, 1i, (_e381 < f32(_e388))));
let _e393 = f32(_e392);
let _e397 = ((_e375 - (_e393 * 0.6933594f)) - (_e393 * -2.1219444e-4f));
let _e419 = ((((1f + (_e397 * (1f + (_e397 * (0.5f + (_e397 * (0.16666667f + (_e397 * (0.041666668f + (_e397 * (0.008333334f + (_e397 * (0.001388889f + (_e397 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e392 + 127i)) << bitcast<u32>(23i)))) * 65535f) + 0.5f);
let _e421 = select(0f, _e419, (_e419 > 0f));
let _e423 = select(65535f, _e421, (_e421 < 65535f));
let _e430 = select(0i, select(select(i32(_e423), i32(-2147483648), (_e423 < -2147483600f)), 2147483647i, (_e423 > 2147483500f)), (_e423 == _e423));
phi_584_ = type_2(_e324, _e328, bitcast<u32>((_e430 - select(0i, 1i, (_e423 < f32(_e430))))));
} else {
phi_584_ = _e285;
}
let _e438 = phi_584_;
let _e440 = bitcast<u32>(((bitcast<i32>(_e110) + (((((_e101 * bitcast<i32>(_e98)) + bitcast<i32>(_e105)) * bitcast<i32>(_e69)) + _e115) * _e95)) + _e120));
if (_e440 < arrayLength((&global_1.member))) {
let _e447 = atomicAdd((&global_1.member[_e440]), (_e122.member_2 | (_e285.member_2 << bitcast<u32>(16i))));
}
phi_183_ = (_e120 + 1i);
phi_186_ = _e438;
} else {
phi_183_ = i32();
phi_186_ = type_2();
}
let _e450 = phi_183_;
let _e452 = phi_186_;
continue;
continuing {
phi_182_ = _e450;
phi_185_ = _e452;
break if !(_e123);
}
}
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
