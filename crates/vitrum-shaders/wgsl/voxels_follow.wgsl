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
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_12 {
member: type_2,
member_1: u32,
member_2: type_5,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_5,
member_8: f32,
member_9: f32,
}
struct type_13 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: type_2,
member_5: u32,
member_6: type_4,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: type_5,
member_11: f32,
member_12: f32,
member_13: f32,
member_14: type_5,
member_15: type_5,
member_16: type_6,
member_17: type_5,
member_18: type_9,
member_19: type_11,
member_20: type_5,
member_21: type_12,
}
struct type_14 {
member: type_13,
}
struct type_16 {
member: array<f32>,
}
struct type_19 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: vec3<f32>,
member_13: vec3<f32>,
member_14: vec3<f32>,
member_15: vec3<f32>,
member_16: vec3<f32>,
member_17: vec3<f32>,
member_18: i32,
member_19: i32,
member_20: i32,
member_21: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(1)
var<storage, read_write> global_2: type_16;
fn function_() {
var phi_1129_: type_19;
let _e63 = global;
let _e68 = global_1.member.member;
if (_e63.x < _e68.member) {
if (_e63.y < _e68.member_1) {
let _e75 = (_e68.member * _e68.member_1);
let _e77 = ((_e63.y * _e68.member) + _e63.x);
let _e78 = bitcast<i32>(_e77);
let _e80 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e82 = select(_e80, _e78, (_e78 < _e80));
let _e88 = global_2.member[bitcast<u32>(select(0i, _e82, (_e82 > 0i)))];
let _e89 = (_e75 + _e77);
let _e90 = bitcast<i32>(_e89);
let _e92 = select(_e80, _e90, (_e90 < _e80));
let _e98 = global_2.member[bitcast<u32>(select(0i, _e92, (_e92 > 0i)))];
let _e100 = ((2u * _e75) + _e77);
let _e101 = bitcast<i32>(_e100);
let _e103 = select(_e80, _e101, (_e101 < _e80));
let _e109 = global_2.member[bitcast<u32>(select(0i, _e103, (_e103 > 0i)))];
let _e111 = ((3u * _e75) + _e77);
let _e112 = bitcast<i32>(_e111);
let _e114 = select(_e80, _e112, (_e112 < _e80));
let _e120 = global_2.member[bitcast<u32>(select(0i, _e114, (_e114 > 0i)))];
let _e122 = ((4u * _e75) + _e77);
let _e123 = bitcast<i32>(_e122);
let _e125 = select(_e80, _e123, (_e123 < _e80));
let _e131 = global_2.member[bitcast<u32>(select(0i, _e125, (_e125 > 0i)))];
let _e133 = ((5u * _e75) + _e77);
let _e134 = bitcast<i32>(_e133);
let _e136 = select(_e80, _e134, (_e134 < _e80));
let _e142 = global_2.member[bitcast<u32>(select(0i, _e136, (_e136 > 0i)))];
let _e144 = ((9u * _e75) + _e77);
let _e145 = bitcast<i32>(_e144);
let _e147 = select(_e80, _e145, (_e145 < _e80));
let _e153 = global_2.member[bitcast<u32>(select(0i, _e147, (_e147 > 0i)))];
let _e155 = ((10u * _e75) + _e77);
let _e156 = bitcast<i32>(_e155);
let _e158 = select(_e80, _e156, (_e156 < _e80));
let _e164 = global_2.member[bitcast<u32>(select(0i, _e158, (_e158 > 0i)))];
let _e166 = ((11u * _e75) + _e77);
let _e167 = bitcast<i32>(_e166);
let _e169 = select(_e80, _e167, (_e167 < _e80));
let _e175 = global_2.member[bitcast<u32>(select(0i, _e169, (_e169 > 0i)))];
let _e177 = ((12u * _e75) + _e77);
let _e178 = bitcast<i32>(_e177);
let _e180 = select(_e80, _e178, (_e178 < _e80));
let _e186 = global_2.member[bitcast<u32>(select(0i, _e180, (_e180 > 0i)))];
let _e188 = ((13u * _e75) + _e77);
let _e189 = bitcast<i32>(_e188);
let _e191 = select(_e80, _e189, (_e189 < _e80));
let _e197 = global_2.member[bitcast<u32>(select(0i, _e191, (_e191 > 0i)))];
let _e199 = ((14u * _e75) + _e77);
let _e200 = bitcast<i32>(_e199);
let _e202 = select(_e80, _e200, (_e200 < _e80));
let _e208 = global_2.member[bitcast<u32>(select(0i, _e202, (_e202 > 0i)))];
let _e210 = ((15u * _e75) + _e77);
let _e211 = bitcast<i32>(_e210);
let _e213 = select(_e80, _e211, (_e211 < _e80));
let _e219 = global_2.member[bitcast<u32>(select(0i, _e213, (_e213 > 0i)))];
let _e221 = ((17u * _e75) + _e77);
let _e222 = bitcast<i32>(_e221);
let _e224 = select(_e80, _e222, (_e222 < _e80));
let _e230 = global_2.member[bitcast<u32>(select(0i, _e224, (_e224 > 0i)))];
let _e232 = ((19u * _e75) + _e77);
let _e233 = bitcast<i32>(_e232);
let _e235 = select(_e80, _e233, (_e233 < _e80));
let _e241 = global_2.member[bitcast<u32>(select(0i, _e235, (_e235 > 0i)))];
let _e243 = ((20u * _e75) + _e77);
let _e244 = bitcast<i32>(_e243);
let _e246 = select(_e80, _e244, (_e244 < _e80));
let _e252 = global_2.member[bitcast<u32>(select(0i, _e246, (_e246 > 0i)))];
let _e254 = ((21u * _e75) + _e77);
let _e255 = bitcast<i32>(_e254);
let _e257 = select(_e80, _e255, (_e255 < _e80));
let _e263 = global_2.member[bitcast<u32>(select(0i, _e257, (_e257 > 0i)))];
let _e265 = ((25u * _e75) + _e77);
let _e266 = bitcast<i32>(_e265);
let _e268 = select(_e80, _e266, (_e266 < _e80));
let _e274 = global_2.member[bitcast<u32>(select(0i, _e268, (_e268 > 0i)))];
let _e276 = ((26u * _e75) + _e77);
let _e277 = bitcast<i32>(_e276);
let _e279 = select(_e80, _e277, (_e277 < _e80));
let _e285 = global_2.member[bitcast<u32>(select(0i, _e279, (_e279 > 0i)))];
let _e287 = ((27u * _e75) + _e77);
let _e288 = bitcast<i32>(_e287);
let _e290 = select(_e80, _e288, (_e288 < _e80));
let _e296 = global_2.member[bitcast<u32>(select(0i, _e290, (_e290 > 0i)))];
let _e298 = ((28u * _e75) + _e77);
let _e299 = bitcast<i32>(_e298);
let _e301 = select(_e80, _e299, (_e299 < _e80));
let _e307 = global_2.member[bitcast<u32>(select(0i, _e301, (_e301 > 0i)))];
let _e309 = ((29u * _e75) + _e77);
let _e310 = bitcast<i32>(_e309);
let _e312 = select(_e80, _e310, (_e310 < _e80));
let _e318 = global_2.member[bitcast<u32>(select(0i, _e312, (_e312 > 0i)))];
let _e320 = ((30u * _e75) + _e77);
let _e321 = bitcast<i32>(_e320);
let _e323 = select(_e80, _e321, (_e321 < _e80));
let _e329 = global_2.member[bitcast<u32>(select(0i, _e323, (_e323 > 0i)))];
let _e331 = ((31u * _e75) + _e77);
let _e332 = bitcast<i32>(_e331);
let _e334 = select(_e80, _e332, (_e332 < _e80));
let _e340 = global_2.member[bitcast<u32>(select(0i, _e334, (_e334 > 0i)))];
let _e342 = ((32u * _e75) + _e77);
let _e343 = bitcast<i32>(_e342);
let _e345 = select(_e80, _e343, (_e343 < _e80));
let _e351 = global_2.member[bitcast<u32>(select(0i, _e345, (_e345 > 0i)))];
let _e353 = ((33u * _e75) + _e77);
let _e354 = bitcast<i32>(_e353);
let _e356 = select(_e80, _e354, (_e354 < _e80));
let _e362 = global_2.member[bitcast<u32>(select(0i, _e356, (_e356 > 0i)))];
let _e364 = ((34u * _e75) + _e77);
let _e365 = bitcast<i32>(_e364);
let _e367 = select(_e80, _e365, (_e365 < _e80));
let _e373 = global_2.member[bitcast<u32>(select(0i, _e367, (_e367 > 0i)))];
let _e375 = ((35u * _e75) + _e77);
let _e376 = bitcast<i32>(_e375);
let _e378 = select(_e80, _e376, (_e376 < _e80));
let _e384 = global_2.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e386 = ((36u * _e75) + _e77);
let _e387 = bitcast<i32>(_e386);
let _e389 = select(_e80, _e387, (_e387 < _e80));
let _e395 = global_2.member[bitcast<u32>(select(0i, _e389, (_e389 > 0i)))];
let _e397 = ((40u * _e75) + _e77);
let _e398 = bitcast<i32>(_e397);
let _e400 = select(_e80, _e398, (_e398 < _e80));
let _e406 = global_2.member[bitcast<u32>(select(0i, _e400, (_e400 > 0i)))];
let _e408 = ((41u * _e75) + _e77);
let _e409 = bitcast<i32>(_e408);
let _e411 = select(_e80, _e409, (_e409 < _e80));
let _e417 = global_2.member[bitcast<u32>(select(0i, _e411, (_e411 > 0i)))];
let _e419 = ((42u * _e75) + _e77);
let _e420 = bitcast<i32>(_e419);
let _e422 = select(_e80, _e420, (_e420 < _e80));
let _e428 = global_2.member[bitcast<u32>(select(0i, _e422, (_e422 > 0i)))];
let _e430 = ((43u * _e75) + _e77);
let _e431 = bitcast<i32>(_e430);
let _e433 = select(_e80, _e431, (_e431 < _e80));
let _e439 = global_2.member[bitcast<u32>(select(0i, _e433, (_e433 > 0i)))];
let _e442 = vec3<f32>(_e153, _e164, _e175);
let _e451 = vec3<f32>(_e274, _e285, _e296);
let _e452 = vec3<f32>(_e307, _e318, _e329);
let _e453 = vec3<f32>(_e340, _e351, _e362);
let _e454 = vec3<f32>(_e373, _e384, _e395);
let _e461 = select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < -2147483600f)), 2147483647i, (_e406 > 2147483500f)), (_e406 == _e406));
if (((_e373 + _e384) + _e395) > 0f) {
let _e484 = (((_e307 * _e307) + (_e318 * _e318)) + (_e329 * _e329));
let _e487 = sqrt(select(0f, _e484, (_e484 > 0f)));
let _e490 = (1f / select(1e-20f, _e487, (_e487 > 1e-20f)));
let _e491 = (_e307 * _e490);
let _e492 = (_e318 * _e490);
let _e493 = (_e329 * _e490);
let _e499 = global_1.member.member_18.member.member;
let _e510 = ((((_e499.member.member * _e274) + (_e499.member.member_1 * _e285)) + (_e499.member.member_2 * _e296)) + _e499.member_1);
let _e516 = -((((_e499.member.member * _e491) + (_e499.member.member_1 * _e492)) + (_e499.member.member_2 * _e493)));
let _e518 = (_e516 > 1e-9f);
let _e522 = ((_e510 / select(1e-9f, _e516, _e518)) - 0.015625f);
let _e525 = select(1e30f, select(0f, _e522, (_e522 > 0f)), ((_e510 > 0f) && _e518));
let _e530 = global_1.member.member_18.member_1.member;
let _e541 = ((((_e530.member.member * _e274) + (_e530.member.member_1 * _e285)) + (_e530.member.member_2 * _e296)) + _e530.member_1);
let _e547 = -((((_e530.member.member * _e491) + (_e530.member.member_1 * _e492)) + (_e530.member.member_2 * _e493)));
let _e549 = (_e547 > 1e-9f);
let _e553 = ((_e541 / select(1e-9f, _e547, _e549)) - 0.015625f);
let _e556 = select(1e30f, select(0f, _e553, (_e553 > 0f)), ((_e541 > 0f) && _e549));
let _e560 = (_e556 < _e525);
let _e566 = global_1.member.member_1;
phi_1129_ = type_19(_e451, vec3<f32>(_e491, _e492, _e493), _e454, _e442, _e453, 0f, select(4f, 0f, ((_e566 & 2u) == 0u)), _e461, 1f, _e241, _e252, _e263, vec3<f32>(0f, 0f, 0f), _e451, _e452, _e453, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), _e461, 0i, select(select(-2i, -3i, _e560), -1i, ((_e525 >= 1e30f) && (_e556 >= 1e30f))), select(_e525, _e556, _e560));
} else {
phi_1129_ = type_19(vec3<f32>(_e88, _e98, _e109), vec3<f32>(_e120, _e131, _e142), _e454, _e442, vec3<f32>(_e186, _e197, _e208), _e219, 1f, select(0i, select(select(i32(_e230), i32(-2147483648), (_e230 < -2147483600f)), 2147483647i, (_e230 > 2147483500f)), (_e230 == _e230)), 0f, _e241, _e252, _e263, vec3<f32>(0f, 0f, 0f), _e451, _e452, _e453, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), _e461, select(0i, select(select(i32(_e417), i32(-2147483648), (_e417 < -2147483600f)), 2147483647i, (_e417 > 2147483500f)), (_e417 == _e417)), select(0i, select(select(i32(_e428), i32(-2147483648), (_e428 < -2147483600f)), 2147483647i, (_e428 > 2147483500f)), (_e428 == _e428)), _e439);
}
let _e572 = phi_1129_;
global_2.member[_e77] = _e572.member.x;
global_2.member[_e89] = _e572.member.y;
global_2.member[_e100] = _e572.member.z;
global_2.member[_e111] = _e572.member_1.x;
global_2.member[_e122] = _e572.member_1.y;
global_2.member[_e133] = _e572.member_1.z;
global_2.member[((6u * _e75) + _e77)] = _e572.member_2.x;
global_2.member[((7u * _e75) + _e77)] = _e572.member_2.y;
global_2.member[((8u * _e75) + _e77)] = _e572.member_2.z;
global_2.member[_e144] = _e572.member_3.x;
global_2.member[_e155] = _e572.member_3.y;
global_2.member[_e166] = _e572.member_3.z;
global_2.member[_e177] = _e572.member_4.x;
global_2.member[_e188] = _e572.member_4.y;
global_2.member[_e199] = _e572.member_4.z;
global_2.member[_e210] = _e572.member_5;
global_2.member[((16u * _e75) + _e77)] = _e572.member_6;
global_2.member[_e221] = f32(_e572.member_7);
global_2.member[((18u * _e75) + _e77)] = _e572.member_8;
global_2.member[_e232] = _e572.member_9;
global_2.member[_e243] = _e572.member_10;
global_2.member[_e254] = _e572.member_11;
global_2.member[((22u * _e75) + _e77)] = _e572.member_12.x;
global_2.member[((23u * _e75) + _e77)] = _e572.member_12.y;
global_2.member[((24u * _e75) + _e77)] = _e572.member_12.z;
global_2.member[_e265] = _e572.member_13.x;
global_2.member[_e276] = _e572.member_13.y;
global_2.member[_e287] = _e572.member_13.z;
global_2.member[_e298] = _e572.member_14.x;
global_2.member[_e309] = _e572.member_14.y;
global_2.member[_e320] = _e572.member_14.z;
global_2.member[_e331] = _e572.member_15.x;
global_2.member[_e342] = _e572.member_15.y;
global_2.member[_e353] = _e572.member_15.z;
global_2.member[_e364] = _e572.member_16.x;
global_2.member[_e375] = _e572.member_16.y;
global_2.member[_e386] = _e572.member_16.z;
global_2.member[((37u * _e75) + _e77)] = _e572.member_17.x;
global_2.member[((38u * _e75) + _e77)] = _e572.member_17.y;
global_2.member[((39u * _e75) + _e77)] = _e572.member_17.z;
global_2.member[_e397] = f32(_e572.member_18);
global_2.member[_e408] = f32(_e572.member_19);
global_2.member[_e419] = f32(_e572.member_20);
global_2.member[_e430] = _e572.member_21;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
