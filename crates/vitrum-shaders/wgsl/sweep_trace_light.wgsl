struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_11 {
member: u32,
member_1: u32,
}
struct type_12 {
member: type_11,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_13 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_14 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_11,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_11,
member_18: type_12,
member_19: type_5,
member_20: type_13,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: array<f32>,
}
struct type_18 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: i32,
member_10: i32,
member_11: type_2,
member_12: u32,
member_13: type_2,
member_14: u32,
member_15: u32,
}
struct type_21 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_18,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_19,
member_8: type_20,
member_9: type_20,
member_10: type_21,
member_11: type_22,
member_12: type_14,
member_13: type_19,
member_14: type_4,
member_15: type_9,
member_16: type_23,
member_17: type_23,
member_18: type_23,
member_19: type_23,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_25 {
member: type_24,
}
struct type_26 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(2)
var<storage, read_write> global_2: type_16;
@group(0) @binding(1)
var<storage> global_3: type_16;
fn function_() {
var local: u32;
var local_1: i32;
var local_2: i32;
var local_3: type_26;
var phi_311_: i32;
var phi_354_: i32;
var phi_547_: i32;
var phi_590_: i32;
var phi_783_: i32;
var phi_826_: i32;
let _e26 = global;
let _e33 = global_1.member.member_2;
let _e36 = global_1.member.member;
let _e44 = (_e26.x + _e33.member);
let _e46 = (_e26.y + _e33.member_1);
if (_e44 < _e33.member_2) {
if (_e46 < _e33.member_3) {
let _e49 = (_e36.member * _e36.member_1);
let _e51 = ((_e46 * _e36.member) + _e44);
local = _e44;
let _e55 = global_1.member.member_10.member;
local_1 = bitcast<i32>((_e46 * _e55));
let _e61 = global_1.member.member_10.member_1;
local_2 = bitcast<i32>((_e55 * _e61));
let _e64 = local_2;
let _e66 = local_1;
let _e68 = local;
let _e70 = (((3i * _e64) + _e66) + bitcast<i32>(_e68));
let _e72 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e74 = select(_e72, _e70, (_e70 < _e72));
let _e79 = global_3.member[bitcast<u32>(select(0i, _e74, (_e74 > 0i)))];
let _e80 = local_2;
let _e82 = local_1;
let _e84 = local;
let _e86 = (((4i * _e80) + _e82) + bitcast<i32>(_e84));
let _e88 = select(_e72, _e86, (_e86 < _e72));
let _e93 = global_3.member[bitcast<u32>(select(0i, _e88, (_e88 > 0i)))];
let _e94 = local_2;
let _e96 = local_1;
let _e98 = local;
let _e100 = (((5i * _e94) + _e96) + bitcast<i32>(_e98));
let _e102 = select(_e72, _e100, (_e100 < _e72));
let _e107 = global_3.member[bitcast<u32>(select(0i, _e102, (_e102 > 0i)))];
let _e111 = global_1.member.member_7.member_2;
let _e114 = (1f / select(1e-6f, _e107, (_e107 > 1e-6f)));
let _e118 = global_1.member.member_10.member_5;
let _e119 = (_e111 * _e118);
let _e124 = global_1.member.member_10.member_6;
let _e126 = (((_e79 * _e114) - _e124) * _e119);
let _e131 = global_1.member.member_10.member_7;
let _e133 = (((_e93 * _e114) - _e131) * _e119);
local_3.member = _e44;
local_3.member_1 = _e46;
local_3.member_2 = -(_e126);
local_3.member_3 = -(_e133);
let _e144 = global_1.member.member_11.member.member;
let _e147 = global_1.member.member_10.member;
let _e148 = bitcast<i32>(_e147);
let _e151 = global_1.member.member_10.member_1;
let _e153 = bitcast<i32>((_e147 * _e151));
let _e155 = local_3.member_1;
let _e158 = ((3i * _e153) + (bitcast<i32>(_e155) * _e148));
let _e159 = local_3.member_2;
let _e160 = -(32768f);
let _e162 = select(_e160, _e159, (_e159 > _e160));
let _e164 = select(32768f, _e162, (_e162 < 32768f));
let _e171 = select(0i, select(select(i32(_e164), i32(-2147483648), (_e164 < -2147483600f)), 2147483647i, (_e164 > 2147483500f)), (_e164 == _e164));
let _e175 = (_e171 - select(0i, 1i, (_e164 < f32(_e171))));
let _e177 = (_e159 - f32(_e175));
let _e178 = (_e175 < 0i);
if _e178 {
phi_311_ = (_e175 + 1i);
} else {
phi_311_ = _e175;
}
let _e181 = phi_311_;
let _e182 = select(1i, -1i, _e178);
let _e184 = select(_e177, (1f - _e177), _e178);
let _e185 = local_3.member_3;
let _e187 = select(_e160, _e185, (_e185 > _e160));
let _e189 = select(32768f, _e187, (_e187 < 32768f));
let _e196 = select(0i, select(select(i32(_e189), i32(-2147483648), (_e189 < -2147483600f)), 2147483647i, (_e189 > 2147483500f)), (_e189 == _e189));
let _e200 = (_e196 - select(0i, 1i, (_e189 < f32(_e196))));
let _e202 = (_e185 - f32(_e200));
let _e203 = (_e200 < 0i);
if _e203 {
phi_354_ = (_e200 + 1i);
} else {
phi_354_ = _e200;
}
let _e206 = phi_354_;
let _e212 = local_3.member;
let _e215 = (((_e158 + (_e206 * _e148)) + bitcast<i32>(_e212)) + _e181);
let _e217 = select(_e72, _e215, (_e215 < _e72));
let _e222 = global_3.member[bitcast<u32>(select(0i, _e217, (_e217 > 0i)))];
let _e223 = (_e215 + _e182);
let _e225 = select(_e72, _e223, (_e223 < _e72));
let _e230 = global_3.member[bitcast<u32>(select(0i, _e225, (_e225 > 0i)))];
let _e233 = (_e222 + ((_e230 - _e222) * _e184));
let _e237 = local_3.member;
let _e240 = (((_e158 + ((_e206 + select(1i, -1i, _e203)) * _e148)) + bitcast<i32>(_e237)) + _e181);
let _e242 = select(_e72, _e240, (_e240 < _e72));
let _e247 = global_3.member[bitcast<u32>(select(0i, _e242, (_e242 > 0i)))];
let _e248 = (_e240 + _e182);
let _e250 = select(_e72, _e248, (_e248 < _e72));
let _e255 = global_3.member[bitcast<u32>(select(0i, _e250, (_e250 > 0i)))];
let _e259 = local_3.member;
let _e262 = local_3.member_2;
let _e263 = (f32(bitcast<i32>(_e259)) + _e262);
let _e264 = local_3.member_1;
let _e267 = local_3.member_3;
let _e268 = (f32(bitcast<i32>(_e264)) + _e267);
let _e270 = (f32(_e148) - 1f);
let _e273 = (f32(bitcast<i32>(_e151)) - 1f);
let _e289 = global_1.member.member_11.member.member_1;
let _e291 = local_3.member_1;
let _e294 = ((4i * _e153) + (bitcast<i32>(_e291) * _e148));
let _e295 = local_3.member_2;
let _e297 = select(_e160, _e295, (_e295 > _e160));
let _e299 = select(32768f, _e297, (_e297 < 32768f));
let _e306 = select(0i, select(select(i32(_e299), i32(-2147483648), (_e299 < -2147483600f)), 2147483647i, (_e299 > 2147483500f)), (_e299 == _e299));
let _e310 = (_e306 - select(0i, 1i, (_e299 < f32(_e306))));
let _e312 = (_e295 - f32(_e310));
let _e313 = (_e310 < 0i);
if _e313 {
phi_547_ = (_e310 + 1i);
} else {
phi_547_ = _e310;
}
let _e316 = phi_547_;
let _e317 = select(1i, -1i, _e313);
let _e319 = select(_e312, (1f - _e312), _e313);
let _e320 = local_3.member_3;
let _e322 = select(_e160, _e320, (_e320 > _e160));
let _e324 = select(32768f, _e322, (_e322 < 32768f));
let _e331 = select(0i, select(select(i32(_e324), i32(-2147483648), (_e324 < -2147483600f)), 2147483647i, (_e324 > 2147483500f)), (_e324 == _e324));
let _e335 = (_e331 - select(0i, 1i, (_e324 < f32(_e331))));
let _e337 = (_e320 - f32(_e335));
let _e338 = (_e335 < 0i);
if _e338 {
phi_590_ = (_e335 + 1i);
} else {
phi_590_ = _e335;
}
let _e341 = phi_590_;
let _e347 = local_3.member;
let _e350 = (((_e294 + (_e341 * _e148)) + bitcast<i32>(_e347)) + _e316);
let _e352 = select(_e72, _e350, (_e350 < _e72));
let _e357 = global_3.member[bitcast<u32>(select(0i, _e352, (_e352 > 0i)))];
let _e358 = (_e350 + _e317);
let _e360 = select(_e72, _e358, (_e358 < _e72));
let _e365 = global_3.member[bitcast<u32>(select(0i, _e360, (_e360 > 0i)))];
let _e368 = (_e357 + ((_e365 - _e357) * _e319));
let _e372 = local_3.member;
let _e375 = (((_e294 + ((_e341 + select(1i, -1i, _e338)) * _e148)) + bitcast<i32>(_e372)) + _e316);
let _e377 = select(_e72, _e375, (_e375 < _e72));
let _e382 = global_3.member[bitcast<u32>(select(0i, _e377, (_e377 > 0i)))];
let _e383 = (_e375 + _e317);
let _e385 = select(_e72, _e383, (_e383 < _e72));
let _e390 = global_3.member[bitcast<u32>(select(0i, _e385, (_e385 > 0i)))];
let _e394 = local_3.member;
let _e397 = local_3.member_2;
let _e398 = (f32(bitcast<i32>(_e394)) + _e397);
let _e399 = local_3.member_1;
let _e402 = local_3.member_3;
let _e403 = (f32(bitcast<i32>(_e399)) + _e402);
let _e419 = global_1.member.member_11.member.member_2;
let _e421 = local_3.member_1;
let _e424 = ((5i * _e153) + (bitcast<i32>(_e421) * _e148));
let _e425 = local_3.member_2;
let _e427 = select(_e160, _e425, (_e425 > _e160));
let _e429 = select(32768f, _e427, (_e427 < 32768f));
let _e436 = select(0i, select(select(i32(_e429), i32(-2147483648), (_e429 < -2147483600f)), 2147483647i, (_e429 > 2147483500f)), (_e429 == _e429));
let _e440 = (_e436 - select(0i, 1i, (_e429 < f32(_e436))));
let _e442 = (_e425 - f32(_e440));
let _e443 = (_e440 < 0i);
if _e443 {
phi_783_ = (_e440 + 1i);
} else {
phi_783_ = _e440;
}
let _e446 = phi_783_;
let _e447 = select(1i, -1i, _e443);
let _e449 = select(_e442, (1f - _e442), _e443);
let _e450 = local_3.member_3;
let _e452 = select(_e160, _e450, (_e450 > _e160));
let _e454 = select(32768f, _e452, (_e452 < 32768f));
let _e461 = select(0i, select(select(i32(_e454), i32(-2147483648), (_e454 < -2147483600f)), 2147483647i, (_e454 > 2147483500f)), (_e454 == _e454));
let _e465 = (_e461 - select(0i, 1i, (_e454 < f32(_e461))));
let _e467 = (_e450 - f32(_e465));
let _e468 = (_e465 < 0i);
if _e468 {
phi_826_ = (_e465 + 1i);
} else {
phi_826_ = _e465;
}
let _e471 = phi_826_;
let _e477 = local_3.member;
let _e480 = (((_e424 + (_e471 * _e148)) + bitcast<i32>(_e477)) + _e446);
let _e482 = select(_e72, _e480, (_e480 < _e72));
let _e487 = global_3.member[bitcast<u32>(select(0i, _e482, (_e482 > 0i)))];
let _e488 = (_e480 + _e447);
let _e490 = select(_e72, _e488, (_e488 < _e72));
let _e495 = global_3.member[bitcast<u32>(select(0i, _e490, (_e490 > 0i)))];
let _e498 = (_e487 + ((_e495 - _e487) * _e449));
let _e502 = local_3.member;
let _e505 = (((_e424 + ((_e471 + select(1i, -1i, _e468)) * _e148)) + bitcast<i32>(_e502)) + _e446);
let _e507 = select(_e72, _e505, (_e505 < _e72));
let _e512 = global_3.member[bitcast<u32>(select(0i, _e507, (_e507 > 0i)))];
let _e513 = (_e505 + _e447);
let _e515 = select(_e72, _e513, (_e513 < _e72));
let _e520 = global_3.member[bitcast<u32>(select(0i, _e515, (_e515 > 0i)))];
let _e524 = local_3.member;
let _e527 = local_3.member_2;
let _e528 = (f32(bitcast<i32>(_e524)) + _e527);
let _e529 = local_3.member_1;
let _e532 = local_3.member_3;
let _e533 = (f32(bitcast<i32>(_e529)) + _e532);
let _e544 = select(_e419, (_e498 + (((_e512 + ((_e520 - _e512) * _e449)) - _e498) * select(_e467, (1f - _e467), _e468))), ((((_e528 >= 0f) && (_e528 <= _e270)) && (_e533 >= 0f)) && (_e533 <= _e273)));
let _e547 = (1f / select(1e-6f, _e544, (_e544 > 1e-6f)));
let _e556 = global_1.member.member_1;
let _e558 = ((_e556 & 1u) != 0u);
global_2.member[_e51] = select((((select(_e144, (_e233 + (((_e247 + ((_e255 - _e247) * _e184)) - _e233) * select(_e202, (1f - _e202), _e203))), ((((_e263 >= 0f) && (_e263 <= _e270)) && (_e268 >= 0f)) && (_e268 <= _e273))) * _e547) - _e124) * _e119), _e126, _e558);
global_2.member[(_e49 + _e51)] = select((((select(_e289, (_e368 + (((_e382 + ((_e390 - _e382) * _e319)) - _e368) * select(_e337, (1f - _e337), _e338))), ((((_e398 >= 0f) && (_e398 <= _e270)) && (_e403 >= 0f)) && (_e403 <= _e273))) * _e547) - _e131) * _e119), _e133, _e558);
global_2.member[((2u * _e49) + _e51)] = _e126;
global_2.member[((3u * _e49) + _e51)] = _e133;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
