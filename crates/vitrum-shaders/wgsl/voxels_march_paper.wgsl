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
struct type_21 {
member: array<u32>,
}
struct type_24 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(4)
var<storage> global_2: type_16;
@group(0) @binding(5)
var<storage, read_write> global_3: type_16;
@group(0) @binding(6)
var<storage, read_write> global_4: type_24;
@group(0) @binding(1)
var<storage> global_5: type_21;
@group(0) @binding(2)
var<storage> global_6: type_21;
@group(0) @binding(3)
var<storage> global_7: type_16;
fn function_() {
var phi_1000_: u32;
var phi_1094_: type_19;
var phi_1097_: i32;
var phi_1716_: type_19;
var phi_1429_: type_19;
var phi_1717_: type_19;
var phi_2529_: type_19;
var phi_2901_: type_19;
var phi_2902_: type_19;
var phi_2955_: type_19;
var phi_2969_: type_19;
var phi_3414_: type_19;
var phi_3415_: type_19;
var phi_3395_: type_19;
var phi_3416_: type_19;
var phi_3424_: type_19;
var phi_3425_: type_19;
var phi_3426_: type_19;
var phi_2049_: type_19;
var phi_3427_: type_19;
var phi_1095_: type_19;
var phi_1098_: i32;
var local: type_19;
var local_1: type_19;
var local_2: type_19;
var local_3: type_19;
var local_4: type_19;
var local_5: type_19;
var local_6: type_19;
var local_7: type_19;
var local_8: type_19;
var local_9: type_19;
var local_10: type_19;
var local_11: type_19;
var local_12: type_19;
var local_13: type_19;
var local_14: type_19;
var local_15: type_19;
var local_16: type_19;
var local_17: type_19;
var local_18: type_19;
var local_19: type_19;
var local_20: type_19;
var local_21: type_19;
var local_22: type_19;
var local_23: type_19;
var local_24: type_19;
var local_25: type_19;
var local_26: type_19;
var local_27: type_19;
var local_28: type_19;
var local_29: type_19;
var local_30: type_19;
var local_31: type_19;
var local_32: type_19;
var local_33: type_19;
var local_34: type_19;
var local_35: type_19;
var local_36: type_19;
var local_37: type_19;
var local_38: type_19;
var local_39: type_19;
var local_40: type_19;
var local_41: type_19;
var local_42: type_19;
var local_43: f32;
let _e98 = global;
let _e106 = arrayLength((&global_2.member));
let _e113 = global_1.member.member;
if (_e98.x < _e113.member) {
if (_e98.y < _e113.member_1) {
let _e120 = (_e113.member * _e113.member_1);
let _e122 = ((_e98.y * _e113.member) + _e98.x);
let _e123 = bitcast<i32>(_e122);
let _e125 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e127 = select(_e125, _e123, (_e123 < _e125));
let _e133 = global_3.member[bitcast<u32>(select(0i, _e127, (_e127 > 0i)))];
let _e134 = (_e120 + _e122);
let _e135 = bitcast<i32>(_e134);
let _e137 = select(_e125, _e135, (_e135 < _e125));
let _e143 = global_3.member[bitcast<u32>(select(0i, _e137, (_e137 > 0i)))];
let _e145 = ((2u * _e120) + _e122);
let _e146 = bitcast<i32>(_e145);
let _e148 = select(_e125, _e146, (_e146 < _e125));
let _e154 = global_3.member[bitcast<u32>(select(0i, _e148, (_e148 > 0i)))];
let _e156 = ((3u * _e120) + _e122);
let _e157 = bitcast<i32>(_e156);
let _e159 = select(_e125, _e157, (_e157 < _e125));
let _e165 = global_3.member[bitcast<u32>(select(0i, _e159, (_e159 > 0i)))];
let _e167 = ((4u * _e120) + _e122);
let _e168 = bitcast<i32>(_e167);
let _e170 = select(_e125, _e168, (_e168 < _e125));
let _e176 = global_3.member[bitcast<u32>(select(0i, _e170, (_e170 > 0i)))];
let _e178 = ((5u * _e120) + _e122);
let _e179 = bitcast<i32>(_e178);
let _e181 = select(_e125, _e179, (_e179 < _e125));
let _e187 = global_3.member[bitcast<u32>(select(0i, _e181, (_e181 > 0i)))];
let _e189 = ((6u * _e120) + _e122);
let _e190 = bitcast<i32>(_e189);
let _e192 = select(_e125, _e190, (_e190 < _e125));
let _e198 = global_3.member[bitcast<u32>(select(0i, _e192, (_e192 > 0i)))];
let _e200 = ((7u * _e120) + _e122);
let _e201 = bitcast<i32>(_e200);
let _e203 = select(_e125, _e201, (_e201 < _e125));
let _e209 = global_3.member[bitcast<u32>(select(0i, _e203, (_e203 > 0i)))];
let _e211 = ((8u * _e120) + _e122);
let _e212 = bitcast<i32>(_e211);
let _e214 = select(_e125, _e212, (_e212 < _e125));
let _e220 = global_3.member[bitcast<u32>(select(0i, _e214, (_e214 > 0i)))];
let _e222 = ((9u * _e120) + _e122);
let _e223 = bitcast<i32>(_e222);
let _e225 = select(_e125, _e223, (_e223 < _e125));
let _e231 = global_3.member[bitcast<u32>(select(0i, _e225, (_e225 > 0i)))];
let _e233 = ((10u * _e120) + _e122);
let _e234 = bitcast<i32>(_e233);
let _e236 = select(_e125, _e234, (_e234 < _e125));
let _e242 = global_3.member[bitcast<u32>(select(0i, _e236, (_e236 > 0i)))];
let _e244 = ((11u * _e120) + _e122);
let _e245 = bitcast<i32>(_e244);
let _e247 = select(_e125, _e245, (_e245 < _e125));
let _e253 = global_3.member[bitcast<u32>(select(0i, _e247, (_e247 > 0i)))];
let _e255 = ((12u * _e120) + _e122);
let _e256 = bitcast<i32>(_e255);
let _e258 = select(_e125, _e256, (_e256 < _e125));
let _e264 = global_3.member[bitcast<u32>(select(0i, _e258, (_e258 > 0i)))];
let _e266 = ((13u * _e120) + _e122);
let _e267 = bitcast<i32>(_e266);
let _e269 = select(_e125, _e267, (_e267 < _e125));
let _e275 = global_3.member[bitcast<u32>(select(0i, _e269, (_e269 > 0i)))];
let _e277 = ((14u * _e120) + _e122);
let _e278 = bitcast<i32>(_e277);
let _e280 = select(_e125, _e278, (_e278 < _e125));
let _e286 = global_3.member[bitcast<u32>(select(0i, _e280, (_e280 > 0i)))];
let _e288 = ((15u * _e120) + _e122);
let _e289 = bitcast<i32>(_e288);
let _e291 = select(_e125, _e289, (_e289 < _e125));
let _e297 = global_3.member[bitcast<u32>(select(0i, _e291, (_e291 > 0i)))];
let _e299 = ((16u * _e120) + _e122);
let _e300 = bitcast<i32>(_e299);
let _e302 = select(_e125, _e300, (_e300 < _e125));
let _e308 = global_3.member[bitcast<u32>(select(0i, _e302, (_e302 > 0i)))];
let _e310 = ((17u * _e120) + _e122);
let _e311 = bitcast<i32>(_e310);
let _e313 = select(_e125, _e311, (_e311 < _e125));
let _e319 = global_3.member[bitcast<u32>(select(0i, _e313, (_e313 > 0i)))];
let _e321 = ((18u * _e120) + _e122);
let _e322 = bitcast<i32>(_e321);
let _e324 = select(_e125, _e322, (_e322 < _e125));
let _e330 = global_3.member[bitcast<u32>(select(0i, _e324, (_e324 > 0i)))];
let _e332 = ((19u * _e120) + _e122);
let _e333 = bitcast<i32>(_e332);
let _e335 = select(_e125, _e333, (_e333 < _e125));
let _e341 = global_3.member[bitcast<u32>(select(0i, _e335, (_e335 > 0i)))];
let _e343 = ((20u * _e120) + _e122);
let _e344 = bitcast<i32>(_e343);
let _e346 = select(_e125, _e344, (_e344 < _e125));
let _e352 = global_3.member[bitcast<u32>(select(0i, _e346, (_e346 > 0i)))];
let _e354 = ((21u * _e120) + _e122);
let _e355 = bitcast<i32>(_e354);
let _e357 = select(_e125, _e355, (_e355 < _e125));
let _e363 = global_3.member[bitcast<u32>(select(0i, _e357, (_e357 > 0i)))];
let _e365 = ((22u * _e120) + _e122);
let _e366 = bitcast<i32>(_e365);
let _e368 = select(_e125, _e366, (_e366 < _e125));
let _e374 = global_3.member[bitcast<u32>(select(0i, _e368, (_e368 > 0i)))];
let _e376 = ((23u * _e120) + _e122);
let _e377 = bitcast<i32>(_e376);
let _e379 = select(_e125, _e377, (_e377 < _e125));
let _e385 = global_3.member[bitcast<u32>(select(0i, _e379, (_e379 > 0i)))];
let _e387 = ((24u * _e120) + _e122);
let _e388 = bitcast<i32>(_e387);
let _e390 = select(_e125, _e388, (_e388 < _e125));
let _e396 = global_3.member[bitcast<u32>(select(0i, _e390, (_e390 > 0i)))];
let _e398 = ((25u * _e120) + _e122);
let _e399 = bitcast<i32>(_e398);
let _e401 = select(_e125, _e399, (_e399 < _e125));
let _e407 = global_3.member[bitcast<u32>(select(0i, _e401, (_e401 > 0i)))];
let _e409 = ((26u * _e120) + _e122);
let _e410 = bitcast<i32>(_e409);
let _e412 = select(_e125, _e410, (_e410 < _e125));
let _e418 = global_3.member[bitcast<u32>(select(0i, _e412, (_e412 > 0i)))];
let _e420 = ((27u * _e120) + _e122);
let _e421 = bitcast<i32>(_e420);
let _e423 = select(_e125, _e421, (_e421 < _e125));
let _e429 = global_3.member[bitcast<u32>(select(0i, _e423, (_e423 > 0i)))];
let _e431 = ((28u * _e120) + _e122);
let _e432 = bitcast<i32>(_e431);
let _e434 = select(_e125, _e432, (_e432 < _e125));
let _e440 = global_3.member[bitcast<u32>(select(0i, _e434, (_e434 > 0i)))];
let _e442 = ((29u * _e120) + _e122);
let _e443 = bitcast<i32>(_e442);
let _e445 = select(_e125, _e443, (_e443 < _e125));
let _e451 = global_3.member[bitcast<u32>(select(0i, _e445, (_e445 > 0i)))];
let _e453 = ((30u * _e120) + _e122);
let _e454 = bitcast<i32>(_e453);
let _e456 = select(_e125, _e454, (_e454 < _e125));
let _e462 = global_3.member[bitcast<u32>(select(0i, _e456, (_e456 > 0i)))];
let _e464 = ((31u * _e120) + _e122);
let _e465 = bitcast<i32>(_e464);
let _e467 = select(_e125, _e465, (_e465 < _e125));
let _e473 = global_3.member[bitcast<u32>(select(0i, _e467, (_e467 > 0i)))];
let _e475 = ((32u * _e120) + _e122);
let _e476 = bitcast<i32>(_e475);
let _e478 = select(_e125, _e476, (_e476 < _e125));
let _e484 = global_3.member[bitcast<u32>(select(0i, _e478, (_e478 > 0i)))];
let _e486 = ((33u * _e120) + _e122);
let _e487 = bitcast<i32>(_e486);
let _e489 = select(_e125, _e487, (_e487 < _e125));
let _e495 = global_3.member[bitcast<u32>(select(0i, _e489, (_e489 > 0i)))];
let _e497 = ((34u * _e120) + _e122);
let _e498 = bitcast<i32>(_e497);
let _e500 = select(_e125, _e498, (_e498 < _e125));
let _e506 = global_3.member[bitcast<u32>(select(0i, _e500, (_e500 > 0i)))];
let _e508 = ((35u * _e120) + _e122);
let _e509 = bitcast<i32>(_e508);
let _e511 = select(_e125, _e509, (_e509 < _e125));
let _e517 = global_3.member[bitcast<u32>(select(0i, _e511, (_e511 > 0i)))];
let _e519 = ((36u * _e120) + _e122);
let _e520 = bitcast<i32>(_e519);
let _e522 = select(_e125, _e520, (_e520 < _e125));
let _e528 = global_3.member[bitcast<u32>(select(0i, _e522, (_e522 > 0i)))];
let _e530 = ((37u * _e120) + _e122);
let _e531 = bitcast<i32>(_e530);
let _e533 = select(_e125, _e531, (_e531 < _e125));
let _e539 = global_3.member[bitcast<u32>(select(0i, _e533, (_e533 > 0i)))];
let _e541 = ((38u * _e120) + _e122);
let _e542 = bitcast<i32>(_e541);
let _e544 = select(_e125, _e542, (_e542 < _e125));
let _e550 = global_3.member[bitcast<u32>(select(0i, _e544, (_e544 > 0i)))];
let _e552 = ((39u * _e120) + _e122);
let _e553 = bitcast<i32>(_e552);
let _e555 = select(_e125, _e553, (_e553 < _e125));
let _e561 = global_3.member[bitcast<u32>(select(0i, _e555, (_e555 > 0i)))];
let _e563 = ((40u * _e120) + _e122);
let _e564 = bitcast<i32>(_e563);
let _e566 = select(_e125, _e564, (_e564 < _e125));
let _e572 = global_3.member[bitcast<u32>(select(0i, _e566, (_e566 > 0i)))];
let _e574 = ((41u * _e120) + _e122);
let _e575 = bitcast<i32>(_e574);
let _e577 = select(_e125, _e575, (_e575 < _e125));
let _e583 = global_3.member[bitcast<u32>(select(0i, _e577, (_e577 > 0i)))];
let _e585 = ((42u * _e120) + _e122);
let _e586 = bitcast<i32>(_e585);
let _e588 = select(_e125, _e586, (_e586 < _e125));
let _e594 = global_3.member[bitcast<u32>(select(0i, _e588, (_e588 > 0i)))];
let _e596 = ((43u * _e120) + _e122);
let _e597 = bitcast<i32>(_e596);
let _e599 = select(_e125, _e597, (_e597 < _e125));
let _e605 = global_3.member[bitcast<u32>(select(0i, _e599, (_e599 > 0i)))];
if (_e308 == 0f) {
phi_1000_ = 3u;
} else {
phi_1000_ = select(0u, 1u, (_e308 == 4f));
}
let _e610 = phi_1000_;
if (_e610 > 0u) {
if (arrayLength((&global_4.member)) >= 3u) {
let _e619 = atomicLoad((&global_4.member[0u]));
if (_e619 == 0u) {
atomicStore((&global_4.member[0u]), ((_e113.member + 7u) / 8u));
atomicStore((&global_4.member[1u]), ((_e113.member_1 + 7u) / 8u));
atomicStore((&global_4.member[2u]), 1u);
}
}
}
if (_e610 > 1u) {
let _e670 = global_1.member.member_2.member;
let _e671 = bitcast<i32>(_e670);
let _e675 = global_1.member.member_2.member_1;
let _e676 = bitcast<i32>(_e675);
let _e680 = global_1.member.member_2.member_2;
let _e681 = bitcast<i32>(_e680);
phi_1094_ = type_19(vec3<f32>(_e133, _e143, _e154), vec3<f32>(_e165, _e176, _e187), vec3<f32>(_e198, _e209, _e220), vec3<f32>(_e231, _e242, _e253), vec3<f32>(_e264, _e275, _e286), _e297, _e308, select(0i, select(select(i32(_e319), i32(-2147483648), (_e319 < -2147483600f)), 2147483647i, (_e319 > 2147483500f)), (_e319 == _e319)), _e330, _e341, _e352, _e363, vec3<f32>(_e374, _e385, _e396), vec3<f32>(_e407, _e418, _e429), vec3<f32>(_e440, _e451, _e462), vec3<f32>(_e473, _e484, _e495), vec3<f32>(_e506, _e517, _e528), vec3<f32>(_e539, _e550, _e561), select(0i, select(select(i32(_e572), i32(-2147483648), (_e572 < -2147483600f)), 2147483647i, (_e572 > 2147483500f)), (_e572 == _e572)), select(0i, select(select(i32(_e583), i32(-2147483648), (_e583 < -2147483600f)), 2147483647i, (_e583 > 2147483500f)), (_e583 == _e583)), select(0i, select(select(i32(_e594), i32(-2147483648), (_e594 < -2147483600f)), 2147483647i, (_e594 > 2147483500f)), (_e594 == _e594)), _e605);
phi_1097_ = 0i;
loop {
let _e686 = phi_1094_;
let _e688 = phi_1097_;
local = _e686;
local_1 = _e686;
local_2 = _e686;
local_3 = _e686;
local_4 = _e686;
local_5 = _e686;
local_6 = _e686;
local_7 = _e686;
local_8 = _e686;
local_9 = _e686;
local_10 = _e686;
local_11 = _e686;
local_12 = _e686;
local_13 = _e686;
local_14 = _e686;
local_15 = _e686;
local_16 = _e686;
local_17 = _e686;
local_18 = _e686;
local_19 = _e686;
local_20 = _e686;
local_21 = _e686;
local_22 = _e686;
local_23 = _e686;
local_24 = _e686;
local_25 = _e686;
local_26 = _e686;
local_27 = _e686;
local_28 = _e686;
local_29 = _e686;
local_30 = _e686;
local_31 = _e686;
local_32 = _e686;
local_33 = _e686;
local_34 = _e686;
local_35 = _e686;
local_36 = _e686;
local_37 = _e686;
local_38 = _e686;
local_39 = _e686;
local_40 = _e686;
local_41 = _e686;
local_42 = _e686;
let _e692 = ((_e688 < 256i) && (_e686.member_6 == 0f));
local_43 = _e686.member_6;
if _e692 {
let _e698 = bitcast<f32>((bitcast<u32>(_e686.member_1.x) & 2147483647u));
let _e702 = bitcast<f32>((bitcast<u32>(_e686.member_1.y) & 2147483647u));
let _e704 = select(_e702, _e698, (_e698 > _e702));
let _e708 = bitcast<f32>((bitcast<u32>(_e686.member_1.z) & 2147483647u));
let _e710 = select(_e708, _e704, (_e704 > _e708));
let _e713 = (1f / select(0.5f, _e710, (_e710 > 0.5f)));
let _e715 = (_e686.member_21 <= _e713);
if _e715 {
let _e1094 = type_19(vec3<f32>((_e686.member.x + (_e686.member_1.x * _e686.member_21)), (_e686.member.y + (_e686.member_1.y * _e686.member_21)), (_e686.member.z + (_e686.member_1.z * _e686.member_21))), _e686.member_1, _e686.member_2, _e686.member_3, _e686.member_4, _e686.member_5, _e686.member_6, _e686.member_7, _e686.member_8, _e686.member_9, _e686.member_10, _e686.member_11, _e686.member_12, _e686.member_13, _e686.member_14, _e686.member_15, _e686.member_16, _e686.member_17, _e686.member_18, _e686.member_19, _e686.member_20, _e686.member_21);
let _e1118 = type_19(_e1094.member, _e1094.member_1, _e1094.member_2, _e1094.member_3, _e1094.member_4, (_e686.member_5 + _e686.member_21), _e1094.member_6, _e1094.member_7, _e1094.member_8, _e1094.member_9, _e1094.member_10, _e1094.member_11, _e1094.member_12, _e1094.member_13, _e1094.member_14, _e1094.member_15, _e1094.member_16, _e1094.member_17, _e1094.member_18, _e1094.member_19, _e1094.member_20, _e1094.member_21);
let _e1141 = type_19(_e1118.member, _e1118.member_1, _e1118.member_2, _e1118.member_3, _e1118.member_4, _e1118.member_5, _e1118.member_6, _e1118.member_7, _e1118.member_8, _e1118.member_9, _e1118.member_10, _e1118.member_11, _e1118.member_12, _e1118.member_13, _e1118.member_14, _e1118.member_15, _e1118.member_16, _e1118.member_17, _e1118.member_18, _e1118.member_19, _e1118.member_20, (_e686.member_21 - _e686.member_21));
let _e1168 = type_19(_e1141.member, _e1141.member_1, _e1141.member_2, _e1141.member_3, _e1141.member_4, _e1141.member_5, _e1141.member_6, _e1141.member_7, _e1141.member_8, _e1141.member_9, (_e686.member_10 + select(0f, _e686.member_21, (_e686.member_8 == 0f))), _e1141.member_11, _e1141.member_12, _e1141.member_13, _e1141.member_14, _e1141.member_15, _e1141.member_16, _e1141.member_17, _e1141.member_18, _e1141.member_19, _e1141.member_20, _e1141.member_21);
if (_e686.member_7 != 16i) {
let _e1193 = type_19(_e1168.member, _e1168.member_1, _e1168.member_2, _e1168.member_3, _e1168.member_4, _e1168.member_5, _e1168.member_6, _e1168.member_7, _e1168.member_8, (_e686.member_9 + _e686.member_21), _e1168.member_10, _e1168.member_11, _e1168.member_12, _e1168.member_13, _e1168.member_14, _e1168.member_15, _e1168.member_16, _e1168.member_17, _e1168.member_18, _e1168.member_19, _e1168.member_20, _e1168.member_21);
let _e1194 = (_e686.member_7 * 4i);
let _e1195 = (_e1194 + 1i);
let _e1197 = (bitcast<i32>(_e106) - 1i);
let _e1199 = select(_e1197, _e1195, (_e1195 < _e1197));
let _e1205 = global_2.member[bitcast<u32>(select(0i, _e1199, (_e1199 > 0i)))];
let _e1207 = -((_e1205 * _e686.member_21));
let _e1209 = select(-87f, _e1207, (_e1207 > -87f));
let _e1211 = select(88f, _e1209, (_e1209 < 88f));
let _e1213 = ((_e1211 * 1.442695f) + 0.5f);
let _e1215 = select(-127f, _e1213, (_e1213 > -127f));
let _e1217 = select(128f, _e1215, (_e1215 < 128f));
let _e1224 = select(0i, select(select(i32(_e1217), i32(-2147483648), (_e1217 < -2147483600f)), 2147483647i, (_e1217 > 2147483500f)), (_e1217 == _e1217));
let _e1228 = (_e1224 - select(0i, 1i, (_e1217 < f32(_e1224))));
let _e1229 = f32(_e1228);
let _e1233 = ((_e1211 - (_e1229 * 0.6933594f)) - (_e1229 * -2.1219444e-4f));
let _e1254 = (_e1194 + 2i);
let _e1256 = select(_e1197, _e1254, (_e1254 < _e1197));
let _e1262 = global_2.member[bitcast<u32>(select(0i, _e1256, (_e1256 > 0i)))];
let _e1264 = -((_e1262 * _e686.member_21));
let _e1266 = select(-87f, _e1264, (_e1264 > -87f));
let _e1268 = select(88f, _e1266, (_e1266 < 88f));
let _e1270 = ((_e1268 * 1.442695f) + 0.5f);
let _e1272 = select(-127f, _e1270, (_e1270 > -127f));
let _e1274 = select(128f, _e1272, (_e1272 < 128f));
let _e1281 = select(0i, select(select(i32(_e1274), i32(-2147483648), (_e1274 < -2147483600f)), 2147483647i, (_e1274 > 2147483500f)), (_e1274 == _e1274));
let _e1285 = (_e1281 - select(0i, 1i, (_e1274 < f32(_e1281))));
let _e1286 = f32(_e1285);
let _e1290 = ((_e1268 - (_e1286 * 0.6933594f)) - (_e1286 * -2.1219444e-4f));
let _e1311 = (_e1194 + 3i);
let _e1313 = select(_e1197, _e1311, (_e1311 < _e1197));
let _e1319 = global_2.member[bitcast<u32>(select(0i, _e1313, (_e1313 > 0i)))];
let _e1321 = -((_e1319 * _e686.member_21));
let _e1323 = select(-87f, _e1321, (_e1321 > -87f));
let _e1325 = select(88f, _e1323, (_e1323 < 88f));
let _e1327 = ((_e1325 * 1.442695f) + 0.5f);
let _e1329 = select(-127f, _e1327, (_e1327 > -127f));
let _e1331 = select(128f, _e1329, (_e1329 < 128f));
let _e1338 = select(0i, select(select(i32(_e1331), i32(-2147483648), (_e1331 < -2147483600f)), 2147483647i, (_e1331 > 2147483500f)), (_e1331 == _e1331));
let _e1342 = (_e1338 - select(0i, 1i, (_e1331 < f32(_e1338))));
let _e1343 = f32(_e1342);
let _e1347 = ((_e1325 - (_e1343 * 0.6933594f)) - (_e1343 * -2.1219444e-4f));
phi_1429_ = type_19(_e1193.member, _e1193.member_1, vec3<f32>((_e686.member_2.x * ((1f + (_e1233 * (1f + (_e1233 * (0.5f + (_e1233 * (0.16666667f + (_e1233 * (0.041666668f + (_e1233 * (0.008333334f + (_e1233 * (0.001388889f + (_e1233 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1228 + 127i)) << bitcast<u32>(23i))))), (_e686.member_2.y * ((1f + (_e1290 * (1f + (_e1290 * (0.5f + (_e1290 * (0.16666667f + (_e1290 * (0.041666668f + (_e1290 * (0.008333334f + (_e1290 * (0.001388889f + (_e1290 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1285 + 127i)) << bitcast<u32>(23i))))), (_e686.member_2.z * ((1f + (_e1347 * (1f + (_e1347 * (0.5f + (_e1347 * (0.16666667f + (_e1347 * (0.041666668f + (_e1347 * (0.008333334f + (_e1347 * (0.001388889f + (_e1347 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1342 + 127i)) << bitcast<u32>(23i)))))), _e1193.member_3, _e1193.member_4, _e1193.member_5, _e1193.member_6, _e1193.member_7, _e1193.member_8, _e1193.member_9, _e1193.member_10, _e1193.member_11, _e1193.member_12, _e1193.member_13, _e1193.member_14, _e1193.member_15, _e1193.member_16, _e1193.member_17, _e1193.member_18, _e1193.member_19, _e1193.member_20, _e1193.member_21);
} else {
phi_1429_ = _e1168;
}
let _e1401 = phi_1429_;
phi_1717_ = type_19(_e1401.member, _e1401.member_1, _e1401.member_2, _e1401.member_3, _e1401.member_4, _e1401.member_5, 3f, _e1401.member_7, _e1401.member_8, _e1401.member_9, _e1401.member_10, _e1401.member_11, _e1401.member_12, _e1401.member_13, _e1401.member_14, _e1401.member_15, _e1401.member_16, _e1401.member_17, _e1401.member_18, _e1401.member_19, _e1401.member_20, _e1401.member_21);
} else {
let _e751 = type_19(vec3<f32>((_e686.member.x + (_e686.member_1.x * _e713)), (_e686.member.y + (_e686.member_1.y * _e713)), (_e686.member.z + (_e686.member_1.z * _e713))), _e686.member_1, _e686.member_2, _e686.member_3, _e686.member_4, _e686.member_5, _e686.member_6, _e686.member_7, _e686.member_8, _e686.member_9, _e686.member_10, _e686.member_11, _e686.member_12, _e686.member_13, _e686.member_14, _e686.member_15, _e686.member_16, _e686.member_17, _e686.member_18, _e686.member_19, _e686.member_20, _e686.member_21);
let _e775 = type_19(_e751.member, _e751.member_1, _e751.member_2, _e751.member_3, _e751.member_4, (_e686.member_5 + _e713), _e751.member_6, _e751.member_7, _e751.member_8, _e751.member_9, _e751.member_10, _e751.member_11, _e751.member_12, _e751.member_13, _e751.member_14, _e751.member_15, _e751.member_16, _e751.member_17, _e751.member_18, _e751.member_19, _e751.member_20, _e751.member_21);
let _e798 = type_19(_e775.member, _e775.member_1, _e775.member_2, _e775.member_3, _e775.member_4, _e775.member_5, _e775.member_6, _e775.member_7, _e775.member_8, _e775.member_9, _e775.member_10, _e775.member_11, _e775.member_12, _e775.member_13, _e775.member_14, _e775.member_15, _e775.member_16, _e775.member_17, _e775.member_18, _e775.member_19, _e775.member_20, (_e686.member_21 - _e713));
let _e825 = type_19(_e798.member, _e798.member_1, _e798.member_2, _e798.member_3, _e798.member_4, _e798.member_5, _e798.member_6, _e798.member_7, _e798.member_8, _e798.member_9, (_e686.member_10 + select(0f, _e713, (_e686.member_8 == 0f))), _e798.member_11, _e798.member_12, _e798.member_13, _e798.member_14, _e798.member_15, _e798.member_16, _e798.member_17, _e798.member_18, _e798.member_19, _e798.member_20, _e798.member_21);
if (_e686.member_7 != 16i) {
let _e850 = type_19(_e825.member, _e825.member_1, _e825.member_2, _e825.member_3, _e825.member_4, _e825.member_5, _e825.member_6, _e825.member_7, _e825.member_8, (_e686.member_9 + _e713), _e825.member_10, _e825.member_11, _e825.member_12, _e825.member_13, _e825.member_14, _e825.member_15, _e825.member_16, _e825.member_17, _e825.member_18, _e825.member_19, _e825.member_20, _e825.member_21);
let _e851 = (_e686.member_7 * 4i);
let _e852 = (_e851 + 1i);
let _e854 = (bitcast<i32>(_e106) - 1i);
let _e856 = select(_e854, _e852, (_e852 < _e854));
let _e862 = global_2.member[bitcast<u32>(select(0i, _e856, (_e856 > 0i)))];
let _e864 = -((_e862 * _e713));
let _e866 = select(-87f, _e864, (_e864 > -87f));
let _e868 = select(88f, _e866, (_e866 < 88f));
let _e870 = ((_e868 * 1.442695f) + 0.5f);
let _e872 = select(-127f, _e870, (_e870 > -127f));
let _e874 = select(128f, _e872, (_e872 < 128f));
let _e881 = select(0i, select(select(i32(_e874), i32(-2147483648), (_e874 < -2147483600f)), 2147483647i, (_e874 > 2147483500f)), (_e874 == _e874));
let _e885 = (_e881 - select(0i, 1i, (_e874 < f32(_e881))));
let _e886 = f32(_e885);
let _e890 = ((_e868 - (_e886 * 0.6933594f)) - (_e886 * -2.1219444e-4f));
let _e911 = (_e851 + 2i);
let _e913 = select(_e854, _e911, (_e911 < _e854));
let _e919 = global_2.member[bitcast<u32>(select(0i, _e913, (_e913 > 0i)))];
let _e921 = -((_e919 * _e713));
let _e923 = select(-87f, _e921, (_e921 > -87f));
let _e925 = select(88f, _e923, (_e923 < 88f));
let _e927 = ((_e925 * 1.442695f) + 0.5f);
let _e929 = select(-127f, _e927, (_e927 > -127f));
let _e931 = select(128f, _e929, (_e929 < 128f));
let _e938 = select(0i, select(select(i32(_e931), i32(-2147483648), (_e931 < -2147483600f)), 2147483647i, (_e931 > 2147483500f)), (_e931 == _e931));
let _e942 = (_e938 - select(0i, 1i, (_e931 < f32(_e938))));
let _e943 = f32(_e942);
let _e947 = ((_e925 - (_e943 * 0.6933594f)) - (_e943 * -2.1219444e-4f));
let _e968 = (_e851 + 3i);
let _e970 = select(_e854, _e968, (_e968 < _e854));
let _e976 = global_2.member[bitcast<u32>(select(0i, _e970, (_e970 > 0i)))];
let _e978 = -((_e976 * _e713));
let _e980 = select(-87f, _e978, (_e978 > -87f));
let _e982 = select(88f, _e980, (_e980 < 88f));
let _e984 = ((_e982 * 1.442695f) + 0.5f);
let _e986 = select(-127f, _e984, (_e984 > -127f));
let _e988 = select(128f, _e986, (_e986 < 128f));
let _e995 = select(0i, select(select(i32(_e988), i32(-2147483648), (_e988 < -2147483600f)), 2147483647i, (_e988 > 2147483500f)), (_e988 == _e988));
let _e999 = (_e995 - select(0i, 1i, (_e988 < f32(_e995))));
let _e1000 = f32(_e999);
let _e1004 = ((_e982 - (_e1000 * 0.6933594f)) - (_e1000 * -2.1219444e-4f));
phi_1716_ = type_19(_e850.member, _e850.member_1, vec3<f32>((_e686.member_2.x * ((1f + (_e890 * (1f + (_e890 * (0.5f + (_e890 * (0.16666667f + (_e890 * (0.041666668f + (_e890 * (0.008333334f + (_e890 * (0.001388889f + (_e890 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e885 + 127i)) << bitcast<u32>(23i))))), (_e686.member_2.y * ((1f + (_e947 * (1f + (_e947 * (0.5f + (_e947 * (0.16666667f + (_e947 * (0.041666668f + (_e947 * (0.008333334f + (_e947 * (0.001388889f + (_e947 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e942 + 127i)) << bitcast<u32>(23i))))), (_e686.member_2.z * ((1f + (_e1004 * (1f + (_e1004 * (0.5f + (_e1004 * (0.16666667f + (_e1004 * (0.041666668f + (_e1004 * (0.008333334f + (_e1004 * (0.001388889f + (_e1004 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e999 + 127i)) << bitcast<u32>(23i)))))), _e850.member_3, _e850.member_4, _e850.member_5, _e850.member_6, _e850.member_7, _e850.member_8, _e850.member_9, _e850.member_10, _e850.member_11, _e850.member_12, _e850.member_13, _e850.member_14, _e850.member_15, _e850.member_16, _e850.member_17, _e850.member_18, _e850.member_19, _e850.member_20, _e850.member_21);
} else {
phi_1716_ = _e825;
}
let _e1058 = phi_1716_;
phi_1717_ = _e1058;
}
let _e1425 = phi_1717_;
if (!(_e715) && ((((((_e1425.member.x < 0f) || (_e1425.member.y < 0f)) || (_e1425.member.z < 0f)) || (_e1425.member.x >= f32(_e671))) || (_e1425.member.y >= f32(_e676))) || (_e1425.member.z >= f32(_e681)))) {
if (_e1425.member_20 == -1i) {
phi_2049_ = type_19(_e1425.member, _e1425.member_1, _e1425.member_2, _e1425.member_3, _e1425.member_4, _e1425.member_5, 1f, _e1425.member_7, _e1425.member_8, _e1425.member_9, _e1425.member_10, _e1425.member_11, _e1425.member_12, _e1425.member_13, _e1425.member_14, _e1425.member_15, _e1425.member_16, _e1425.member_17, _e1425.member_18, _e1425.member_19, _e1425.member_20, _e1425.member_21);
} else {
let _e2847 = type_19(vec3<f32>((_e1425.member.x + (_e1425.member_1.x * _e1425.member_21)), (_e1425.member.y + (_e1425.member_1.y * _e1425.member_21)), (_e1425.member.z + (_e1425.member_1.z * _e1425.member_21))), _e1425.member_1, _e1425.member_2, _e1425.member_3, _e1425.member_4, _e1425.member_5, _e1425.member_6, _e1425.member_7, _e1425.member_8, _e1425.member_9, _e1425.member_10, _e1425.member_11, _e1425.member_12, _e1425.member_13, _e1425.member_14, _e1425.member_15, _e1425.member_16, _e1425.member_17, _e1425.member_18, _e1425.member_19, _e1425.member_20, _e1425.member_21);
let _e2871 = type_19(_e2847.member, _e2847.member_1, _e2847.member_2, _e2847.member_3, _e2847.member_4, (_e1425.member_5 + _e1425.member_21), _e2847.member_6, _e2847.member_7, _e2847.member_8, _e2847.member_9, _e2847.member_10, _e2847.member_11, _e2847.member_12, _e2847.member_13, _e2847.member_14, _e2847.member_15, _e2847.member_16, _e2847.member_17, _e2847.member_18, _e2847.member_19, _e2847.member_20, _e2847.member_21);
let _e2894 = type_19(_e2871.member, _e2871.member_1, _e2871.member_2, _e2871.member_3, _e2871.member_4, _e2871.member_5, _e2871.member_6, _e2871.member_7, _e2871.member_8, _e2871.member_9, _e2871.member_10, _e2871.member_11, _e2871.member_12, _e2871.member_13, _e2871.member_14, _e2871.member_15, _e2871.member_16, _e2871.member_17, _e2871.member_18, _e2871.member_19, _e2871.member_20, (_e1425.member_21 - _e1425.member_21));
let _e2921 = type_19(_e2894.member, _e2894.member_1, _e2894.member_2, _e2894.member_3, _e2894.member_4, _e2894.member_5, _e2894.member_6, _e2894.member_7, _e2894.member_8, _e2894.member_9, (_e1425.member_10 + select(0f, _e1425.member_21, (_e1425.member_8 == 0f))), _e2894.member_11, _e2894.member_12, _e2894.member_13, _e2894.member_14, _e2894.member_15, _e2894.member_16, _e2894.member_17, _e2894.member_18, _e2894.member_19, _e2894.member_20, _e2894.member_21);
phi_2049_ = type_19(_e2921.member, _e2921.member_1, _e2921.member_2, _e2921.member_3, _e2921.member_4, _e2921.member_5, 3f, _e2921.member_7, _e2921.member_8, _e2921.member_9, _e2921.member_10, _e2921.member_11, _e2921.member_12, _e2921.member_13, _e2921.member_14, _e2921.member_15, _e2921.member_16, _e2921.member_17, _e2921.member_18, _e2921.member_19, _e2921.member_20, _e2921.member_21);
}
let _e2967 = phi_2049_;
phi_3427_ = _e2967;
} else {
if _e715 {
phi_3426_ = _e1425;
} else {
let _e1447 = f32((_e671 - 1i));
let _e1449 = select(0f, _e1425.member.x, (_e1425.member.x > 0f));
let _e1451 = select(_e1447, _e1449, (_e1449 < _e1447));
let _e1458 = select(0i, select(select(i32(_e1451), i32(-2147483648), (_e1451 < -2147483600f)), 2147483647i, (_e1451 > 2147483500f)), (_e1451 == _e1451));
let _e1462 = (_e1458 - select(0i, 1i, (_e1451 < f32(_e1458))));
let _e1464 = f32((_e676 - 1i));
let _e1466 = select(0f, _e1425.member.y, (_e1425.member.y > 0f));
let _e1468 = select(_e1464, _e1466, (_e1466 < _e1464));
let _e1475 = select(0i, select(select(i32(_e1468), i32(-2147483648), (_e1468 < -2147483600f)), 2147483647i, (_e1468 > 2147483500f)), (_e1468 == _e1468));
let _e1481 = f32((_e681 - 1i));
let _e1483 = select(0f, _e1425.member.z, (_e1425.member.z > 0f));
let _e1485 = select(_e1481, _e1483, (_e1483 < _e1481));
let _e1492 = select(0i, select(select(i32(_e1485), i32(-2147483648), (_e1485 < -2147483600f)), 2147483647i, (_e1485 > 2147483500f)), (_e1485 == _e1485));
let _e1502 = (((((_e1492 - select(0i, 1i, (_e1485 < f32(_e1492)))) * _e676) + (_e1475 - select(0i, 1i, (_e1468 < f32(_e1475))))) * ((_e671 + 31i) >> bitcast<u32>(5i))) + (_e1462 >> bitcast<u32>(5i)));
let _e1504 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1506 = select(_e1504, _e1502, (_e1502 < _e1504));
let _e1512 = global_5.member[bitcast<u32>(select(0i, _e1506, (_e1506 > 0i)))];
let _e1515 = (bitcast<u32>((_e1462 & 31i)) & 31u);
if (((_e1512 >> bitcast<u32>(_e1515)) & 1u) == 1u) {
let _e1521 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e1523 = select(_e1521, _e1502, (_e1502 < _e1521));
let _e1529 = global_6.member[bitcast<u32>(select(0i, _e1523, (_e1523 > 0i)))];
let _e1537 = (bitcast<i32>((_e1529 + countOneBits((_e1512 & ((1u << bitcast<u32>(_e1515)) - 1u))))) * 4i);
let _e1539 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1541 = select(_e1539, _e1537, (_e1537 < _e1539));
let _e1547 = global_7.member[bitcast<u32>(select(0i, _e1541, (_e1541 > 0i)))];
let _e1548 = (_e1537 + 1i);
let _e1550 = select(_e1539, _e1548, (_e1548 < _e1539));
let _e1556 = global_7.member[bitcast<u32>(select(0i, _e1550, (_e1550 > 0i)))];
let _e1557 = (_e1537 + 2i);
let _e1559 = select(_e1539, _e1557, (_e1557 < _e1539));
let _e1565 = global_7.member[bitcast<u32>(select(0i, _e1559, (_e1559 > 0i)))];
let _e1566 = vec3<f32>(_e1547, _e1556, _e1565);
let _e1567 = (_e1537 + 3i);
let _e1569 = select(_e1539, _e1567, (_e1567 < _e1539));
let _e1575 = global_7.member[bitcast<u32>(select(0i, _e1569, (_e1569 > 0i)))];
let _e1577 = select(0f, _e1575, (_e1575 > 0f));
let _e1579 = select(16f, _e1577, (_e1577 < 16f));
let _e1586 = select(0i, select(select(i32(_e1579), i32(-2147483648), (_e1579 < -2147483600f)), 2147483647i, (_e1579 > 2147483500f)), (_e1579 == _e1579));
let _e1595 = (((_e686.member_1.x * _e1547) + (_e686.member_1.y * _e1556)) + (_e686.member_1.z * _e1565));
let _e1597 = select(16i, (_e1586 - select(0i, 1i, (_e1579 < f32(_e1586)))), (_e1595 < 0f));
let _e1611 = global_1.member.member_12;
if ((!(((_e1425.member_8 > 0f) && ((((_e1547 * _e1425.member_4.x) + (_e1556 * _e1425.member_4.y)) + (_e1565 * _e1425.member_4.z)) > _e1611))) && (_e1595 != 0f)) && (_e1597 != _e1425.member_7)) {
let _e1621 = (_e1425.member_7 * 4i);
let _e1623 = (bitcast<i32>(_e106) - 1i);
let _e1625 = select(_e1623, _e1621, (_e1621 < _e1623));
let _e1631 = global_2.member[bitcast<u32>(select(0i, _e1625, (_e1625 > 0i)))];
let _e1632 = (_e1425.member_7 == 16i);
let _e1633 = select(_e1631, 1f, _e1632);
let _e1634 = (_e1597 * 4i);
let _e1636 = select(_e1623, _e1634, (_e1634 < _e1623));
let _e1642 = global_2.member[bitcast<u32>(select(0i, _e1636, (_e1636 > 0i)))];
let _e1644 = select(_e1642, 1f, (_e1597 == 16i));
let _e1654 = select(1f, -1f, ((((_e1425.member_1.x * _e1547) + (_e1425.member_1.y * _e1556)) + (_e1425.member_1.z * _e1565)) > 0f));
let _e1655 = (_e1547 * _e1654);
let _e1656 = (_e1556 * _e1654);
let _e1657 = (_e1565 * _e1654);
let _e1663 = -((((_e1425.member_1.x * _e1655) + (_e1425.member_1.y * _e1656)) + (_e1425.member_1.z * _e1657)));
let _e1665 = select(0f, _e1663, (_e1663 > 0f));
let _e1666 = (_e1633 / _e1644);
let _e1668 = (_e1665 * _e1665);
let _e1671 = (1f - ((_e1666 * _e1666) * (1f - _e1668)));
let _e1672 = (_e1671 <= 0f);
let _e1680 = ((_e1666 * _e1665) - sqrt(select(0f, _e1671, (_e1671 > 0f))));
let _e1687 = (2f * _e1665);
let _e1688 = (_e1655 * _e1687);
let _e1689 = (_e1656 * _e1687);
let _e1690 = (_e1657 * _e1687);
let _e1696 = select(((_e1425.member_1.x * _e1666) + (_e1655 * _e1680)), (_e1425.member_1.x + _e1688), _e1672);
let _e1697 = select(((_e1425.member_1.y * _e1666) + (_e1656 * _e1680)), (_e1425.member_1.y + _e1689), _e1672);
let _e1698 = select(((_e1425.member_1.z * _e1666) + (_e1657 * _e1680)), (_e1425.member_1.z + _e1690), _e1672);
let _e1703 = (((_e1696 * _e1696) + (_e1697 * _e1697)) + (_e1698 * _e1698));
let _e1706 = sqrt(select(0f, _e1703, (_e1703 > 0f)));
let _e1709 = (1f / select(1e-20f, _e1706, (_e1706 > 1e-20f)));
let _e1714 = (_e1644 / _e1633);
let _e1717 = (((_e1714 * _e1714) - 1f) + _e1668);
let _e1720 = sqrt(select(0f, _e1717, (_e1717 > 0f)));
let _e1721 = (_e1720 - _e1665);
let _e1722 = (_e1720 + _e1665);
let _e1725 = (_e1721 / select(1e-6f, _e1722, (_e1722 > 1e-6f)));
let _e1729 = ((_e1665 * _e1721) + 1f);
let _e1732 = (((_e1665 * _e1722) - 1f) / select(1e-6f, _e1729, (_e1729 > 1e-6f)));
let _e1742 = (_e1425.member_8 == 0f);
let _e1745 = global_1.member.member_1;
let _e1748 = select(0f, select(select((((0.5f * _e1725) * _e1725) * (1f + (_e1732 * _e1732))), 1f, (_e1717 <= 0f)), 0f, (_e1633 == _e1644)), ((_e1745 & 1u) != 0u));
let _e1749 = (_e1742 && _e1632);
if _e1742 {
let _e1771 = type_19(_e1425.member, _e1425.member_1, _e1425.member_2, _e1566, _e1425.member_4, _e1425.member_5, _e1425.member_6, _e1425.member_7, _e1425.member_8, _e1425.member_9, _e1425.member_10, _e1425.member_11, _e1425.member_12, _e1425.member_13, _e1425.member_14, _e1425.member_15, _e1425.member_16, _e1425.member_17, _e1425.member_18, _e1425.member_19, _e1425.member_20, _e1425.member_21);
phi_2529_ = type_19(_e1771.member, _e1771.member_1, _e1771.member_2, _e1771.member_3, _e1771.member_4, _e1771.member_5, _e1771.member_6, _e1771.member_7, _e1771.member_8, _e1771.member_9, _e1771.member_10, select(0f, _e1748, _e1749), _e1771.member_12, _e1771.member_13, _e1771.member_14, _e1771.member_15, _e1771.member_16, _e1771.member_17, _e1771.member_18, _e1771.member_19, _e1771.member_20, _e1771.member_21);
} else {
phi_2529_ = _e1425;
}
let _e1796 = phi_2529_;
let _e1798 = !(_e1672);
if (!(_e1749) && _e1798) {
let _e1804 = select(_e1796.member_5, _e1796.member_9, (_e1796.member_8 == 0f));
let _e1805 = (_e1621 + 1i);
let _e1807 = select(_e1623, _e1805, (_e1805 < _e1623));
let _e1813 = global_2.member[bitcast<u32>(select(0i, _e1807, (_e1807 > 0i)))];
let _e1815 = -((_e1813 * _e1804));
let _e1817 = select(-87f, _e1815, (_e1815 > -87f));
let _e1819 = select(88f, _e1817, (_e1817 < 88f));
let _e1821 = ((_e1819 * 1.442695f) + 0.5f);
let _e1823 = select(-127f, _e1821, (_e1821 > -127f));
let _e1825 = select(128f, _e1823, (_e1823 < 128f));
let _e1832 = select(0i, select(select(i32(_e1825), i32(-2147483648), (_e1825 < -2147483600f)), 2147483647i, (_e1825 > 2147483500f)), (_e1825 == _e1825));
let _e1836 = (_e1832 - select(0i, 1i, (_e1825 < f32(_e1832))));
let _e1837 = f32(_e1836);
let _e1841 = ((_e1819 - (_e1837 * 0.6933594f)) - (_e1837 * -2.1219444e-4f));
let _e1862 = (_e1621 + 2i);
let _e1864 = select(_e1623, _e1862, (_e1862 < _e1623));
let _e1870 = global_2.member[bitcast<u32>(select(0i, _e1864, (_e1864 > 0i)))];
let _e1872 = -((_e1870 * _e1804));
let _e1874 = select(-87f, _e1872, (_e1872 > -87f));
let _e1876 = select(88f, _e1874, (_e1874 < 88f));
let _e1878 = ((_e1876 * 1.442695f) + 0.5f);
let _e1880 = select(-127f, _e1878, (_e1878 > -127f));
let _e1882 = select(128f, _e1880, (_e1880 < 128f));
let _e1889 = select(0i, select(select(i32(_e1882), i32(-2147483648), (_e1882 < -2147483600f)), 2147483647i, (_e1882 > 2147483500f)), (_e1882 == _e1882));
let _e1893 = (_e1889 - select(0i, 1i, (_e1882 < f32(_e1889))));
let _e1894 = f32(_e1893);
let _e1898 = ((_e1876 - (_e1894 * 0.6933594f)) - (_e1894 * -2.1219444e-4f));
let _e1919 = (_e1621 + 3i);
let _e1921 = select(_e1623, _e1919, (_e1919 < _e1623));
let _e1927 = global_2.member[bitcast<u32>(select(0i, _e1921, (_e1921 > 0i)))];
let _e1929 = -((_e1927 * _e1804));
let _e1931 = select(-87f, _e1929, (_e1929 > -87f));
let _e1933 = select(88f, _e1931, (_e1931 < 88f));
let _e1935 = ((_e1933 * 1.442695f) + 0.5f);
let _e1937 = select(-127f, _e1935, (_e1935 > -127f));
let _e1939 = select(128f, _e1937, (_e1937 < 128f));
let _e1946 = select(0i, select(select(i32(_e1939), i32(-2147483648), (_e1939 < -2147483600f)), 2147483647i, (_e1939 > 2147483500f)), (_e1939 == _e1939));
let _e1950 = (_e1946 - select(0i, 1i, (_e1939 < f32(_e1946))));
let _e1951 = f32(_e1950);
let _e1955 = ((_e1933 - (_e1951 * 0.6933594f)) - (_e1951 * -2.1219444e-4f));
let _e1977 = select(((1f + (_e1841 * (1f + (_e1841 * (0.5f + (_e1841 * (0.16666667f + (_e1841 * (0.041666668f + (_e1841 * (0.008333334f + (_e1841 * (0.001388889f + (_e1841 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1836 + 127i)) << bitcast<u32>(23i)))), 1f, _e1632);
let _e1979 = (1f - (_e1748 * _e1977));
let _e1981 = (1f - _e1748);
let _e1987 = select(((1f + (_e1898 * (1f + (_e1898 * (0.5f + (_e1898 * (0.16666667f + (_e1898 * (0.041666668f + (_e1898 * (0.008333334f + (_e1898 * (0.001388889f + (_e1898 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1893 + 127i)) << bitcast<u32>(23i)))), 1f, _e1632);
let _e1989 = (1f - (_e1748 * _e1987));
let _e1996 = select(((1f + (_e1955 * (1f + (_e1955 * (0.5f + (_e1955 * (0.16666667f + (_e1955 * (0.041666668f + (_e1955 * (0.008333334f + (_e1955 * (0.001388889f + (_e1955 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1950 + 127i)) << bitcast<u32>(23i)))), 1f, _e1632);
let _e1998 = (1f - (_e1748 * _e1996));
let _e2011 = ((_e1796.member_2.x * select(1f, ((_e1981 * _e1977) / select(1e-9f, _e1979, (_e1979 > 1e-9f))), (_e1979 > 0f))) * _e1748);
let _e2012 = ((_e1796.member_2.y * select(1f, ((_e1981 * _e1987) / select(1e-9f, _e1989, (_e1989 > 1e-9f))), (_e1989 > 0f))) * _e1748);
let _e2013 = ((_e1796.member_2.z * select(1f, ((_e1981 * _e1996) / select(1e-9f, _e1998, (_e1998 > 1e-9f))), (_e1998 > 0f))) * _e1748);
if (((_e1745 & 8u) != 0u) && (((_e2011 + _e2012) + _e2013) > ((_e1796.member_17.x + _e1796.member_17.y) + _e1796.member_17.z))) {
let _e2090 = type_19(_e1796.member, _e1796.member_1, _e1796.member_2, _e1796.member_3, _e1796.member_4, _e1796.member_5, _e1796.member_6, _e1796.member_7, _e1796.member_8, _e1796.member_9, _e1796.member_10, _e1796.member_11, vec3<f32>((_e1796.member_12.x + _e1796.member_17.x), (_e1796.member_12.y + _e1796.member_17.y), (_e1796.member_12.z + _e1796.member_17.z)), _e1796.member_13, _e1796.member_14, _e1796.member_15, _e1796.member_16, _e1796.member_17, _e1796.member_18, _e1796.member_19, _e1796.member_20, _e1796.member_21);
let _e2113 = type_19(_e2090.member, _e2090.member_1, _e2090.member_2, _e2090.member_3, _e2090.member_4, _e2090.member_5, _e2090.member_6, _e2090.member_7, _e2090.member_8, _e2090.member_9, _e2090.member_10, _e2090.member_11, _e2090.member_12, _e1796.member, _e2090.member_14, _e2090.member_15, _e2090.member_16, _e2090.member_17, _e2090.member_18, _e2090.member_19, _e2090.member_20, _e2090.member_21);
let _e2135 = type_19(_e2113.member, _e2113.member_1, _e2113.member_2, _e2113.member_3, _e2113.member_4, _e2113.member_5, _e2113.member_6, _e2113.member_7, _e2113.member_8, _e2113.member_9, _e2113.member_10, _e2113.member_11, _e2113.member_12, _e2113.member_13, (_e1425.member_1 + vec3<f32>(_e1688, _e1689, _e1690)), _e2113.member_15, _e2113.member_16, _e2113.member_17, _e2113.member_18, _e2113.member_19, _e2113.member_20, _e2113.member_21);
let _e2157 = type_19(_e2135.member, _e2135.member_1, _e2135.member_2, _e2135.member_3, _e2135.member_4, _e2135.member_5, _e2135.member_6, _e2135.member_7, _e2135.member_8, _e2135.member_9, _e2135.member_10, _e2135.member_11, _e2135.member_12, _e2135.member_13, _e2135.member_14, _e1566, _e2135.member_16, _e2135.member_17, _e2135.member_18, _e2135.member_19, _e2135.member_20, _e2135.member_21);
let _e2180 = type_19(_e2157.member, _e2157.member_1, _e2157.member_2, _e2157.member_3, _e2157.member_4, _e2157.member_5, _e2157.member_6, _e2157.member_7, _e2157.member_8, _e2157.member_9, _e2157.member_10, _e2157.member_11, _e2157.member_12, _e2157.member_13, _e2157.member_14, _e2157.member_15, (_e1796.member_2 * _e1748), _e2157.member_17, _e2157.member_18, _e2157.member_19, _e2157.member_20, _e2157.member_21);
let _e2202 = type_19(_e2180.member, _e2180.member_1, _e2180.member_2, _e2180.member_3, _e2180.member_4, _e2180.member_5, _e2180.member_6, _e2180.member_7, _e2180.member_8, _e2180.member_9, _e2180.member_10, _e2180.member_11, _e2180.member_12, _e2180.member_13, _e2180.member_14, _e2180.member_15, _e2180.member_16, vec3<f32>(_e2011, _e2012, _e2013), _e2180.member_18, _e2180.member_19, _e2180.member_20, _e2180.member_21);
phi_2901_ = type_19(_e2202.member, _e2202.member_1, _e2202.member_2, _e2202.member_3, _e2202.member_4, _e2202.member_5, _e2202.member_6, _e2202.member_7, _e2202.member_8, _e2202.member_9, _e2202.member_10, _e2202.member_11, _e2202.member_12, _e2202.member_13, _e2202.member_14, _e2202.member_15, _e2202.member_16, _e2202.member_17, _e1796.member_7, _e2202.member_19, _e2202.member_20, _e2202.member_21);
} else {
phi_2901_ = type_19(_e1796.member, _e1796.member_1, _e1796.member_2, _e1796.member_3, _e1796.member_4, _e1796.member_5, _e1796.member_6, _e1796.member_7, _e1796.member_8, _e1796.member_9, _e1796.member_10, _e1796.member_11, vec3<f32>((_e1796.member_12.x + _e2011), (_e1796.member_12.y + _e2012), (_e1796.member_12.z + _e2013)), _e1796.member_13, _e1796.member_14, _e1796.member_15, _e1796.member_16, _e1796.member_17, _e1796.member_18, _e1796.member_19, _e1796.member_20, _e1796.member_21);
}
let _e2227 = phi_2901_;
phi_2902_ = _e2227;
} else {
phi_2902_ = _e1796;
}
let _e2229 = phi_2902_;
let _e2231 = (_e2229.member_8 + 1f);
let _e2253 = type_19(_e2229.member, _e2229.member_1, _e2229.member_2, _e2229.member_3, _e2229.member_4, _e2229.member_5, _e2229.member_6, _e2229.member_7, _e2231, _e2229.member_9, _e2229.member_10, _e2229.member_11, _e2229.member_12, _e2229.member_13, _e2229.member_14, _e2229.member_15, _e2229.member_16, _e2229.member_17, _e2229.member_18, _e2229.member_19, _e2229.member_20, _e2229.member_21);
let _e2256 = ((_e113.member_2 == 0u) && (_e2231 >= 2f));
if (_e1672 && _e2256) {
let _e2288 = (((_e2229.member_1.x * _e1547) + (_e2229.member_1.y * _e1556)) + (_e2229.member_1.z * _e1565));
let _e2292 = (_e2229.member_1.x - (_e1547 * _e2288));
let _e2293 = (_e2229.member_1.y - (_e1556 * _e2288));
let _e2294 = (_e2229.member_1.z - (_e1565 * _e2288));
let _e2299 = (((_e2292 * _e2292) + (_e2293 * _e2293)) + (_e2294 * _e2294));
let _e2302 = sqrt(select(0f, _e2299, (_e2299 > 0f)));
let _e2305 = (1f / select(1e-20f, _e2302, (_e2302 > 1e-20f)));
phi_2955_ = type_19(_e2253.member, vec3<f32>((_e2292 * _e2305), (_e2293 * _e2305), (_e2294 * _e2305)), _e2253.member_2, _e2253.member_3, _e2253.member_4, _e2253.member_5, _e2253.member_6, _e2253.member_7, _e2253.member_8, _e2253.member_9, _e2253.member_10, _e2253.member_11, _e2253.member_12, _e2253.member_13, _e2253.member_14, _e2253.member_15, _e2253.member_16, _e2253.member_17, _e2253.member_18, _e2253.member_19, _e2253.member_20, _e2253.member_21);
} else {
phi_2955_ = type_19(_e2253.member, vec3<f32>((_e1696 * _e1709), (_e1697 * _e1709), (_e1698 * _e1709)), _e2253.member_2, _e2253.member_3, _e2253.member_4, _e2253.member_5, _e2253.member_6, _e2253.member_7, _e2253.member_8, _e2253.member_9, _e2253.member_10, _e2253.member_11, _e2253.member_12, _e2253.member_13, _e2253.member_14, _e2253.member_15, _e2253.member_16, _e2253.member_17, _e2253.member_18, _e2253.member_19, _e2253.member_20, _e2253.member_21);
}
let _e2333 = phi_2955_;
if _e1672 {
phi_2969_ = _e2333;
} else {
let _e2334 = (1f - _e1748);
phi_2969_ = type_19(_e2333.member, _e2333.member_1, vec3<f32>((_e2333.member_2.x * _e2334), (_e2333.member_2.y * _e2334), (_e2333.member_2.z * _e2334)), _e2333.member_3, _e2333.member_4, _e2333.member_5, _e2333.member_6, _e2333.member_7, _e2333.member_8, _e2333.member_9, _e2333.member_10, _e2333.member_11, _e2333.member_12, _e2333.member_13, _e2333.member_14, _e2333.member_15, _e2333.member_16, _e2333.member_17, _e2333.member_18, _e2333.member_19, _e2333.member_20, _e2333.member_21);
}
let _e2368 = phi_2969_;
let _e2390 = type_19(_e2368.member, _e2368.member_1, _e2368.member_2, _e2368.member_3, _e2368.member_4, 0f, _e2368.member_6, _e2368.member_7, _e2368.member_8, _e2368.member_9, _e2368.member_10, _e2368.member_11, _e2368.member_12, _e2368.member_13, _e2368.member_14, _e2368.member_15, _e2368.member_16, _e2368.member_17, _e2368.member_18, _e2368.member_19, _e2368.member_20, _e2368.member_21);
let _e2397 = global_1.member.member_18.member.member;
let _e2411 = ((((_e2397.member.member * _e2368.member.x) + (_e2397.member.member_1 * _e2368.member.y)) + (_e2397.member.member_2 * _e2368.member.z)) + _e2397.member_1);
let _e2420 = -((((_e2397.member.member * _e2368.member_1.x) + (_e2397.member.member_1 * _e2368.member_1.y)) + (_e2397.member.member_2 * _e2368.member_1.z)));
let _e2422 = (_e2420 > 1e-9f);
let _e2426 = ((_e2411 / select(1e-9f, _e2420, _e2422)) - 0.015625f);
let _e2429 = select(1e30f, select(0f, _e2426, (_e2426 > 0f)), ((_e2411 > 0f) && _e2422));
let _e2434 = global_1.member.member_18.member_1.member;
let _e2445 = ((((_e2434.member.member * _e2368.member.x) + (_e2434.member.member_1 * _e2368.member.y)) + (_e2434.member.member_2 * _e2368.member.z)) + _e2434.member_1);
let _e2451 = -((((_e2434.member.member * _e2368.member_1.x) + (_e2434.member.member_1 * _e2368.member_1.y)) + (_e2434.member.member_2 * _e2368.member_1.z)));
let _e2453 = (_e2451 > 1e-9f);
let _e2457 = ((_e2445 / select(1e-9f, _e2451, _e2453)) - 0.015625f);
let _e2460 = select(1e30f, select(0f, _e2457, (_e2457 > 0f)), ((_e2445 > 0f) && _e2453));
let _e2464 = (_e2460 < _e2429);
let _e2466 = select(select(-2i, -3i, _e2464), -1i, ((_e2429 >= 1e30f) && (_e2460 >= 1e30f)));
let _e2467 = select(_e2429, _e2460, _e2464);
let _e2489 = type_19(_e2390.member, _e2390.member_1, _e2390.member_2, _e2390.member_3, _e2390.member_4, _e2390.member_5, _e2390.member_6, _e2390.member_7, _e2390.member_8, _e2390.member_9, _e2390.member_10, _e2390.member_11, _e2390.member_12, _e2390.member_13, _e2390.member_14, _e2390.member_15, _e2390.member_16, _e2390.member_17, _e2390.member_18, 0i, _e2390.member_20, _e2390.member_21);
let _e2511 = type_19(_e2489.member, _e2489.member_1, _e2489.member_2, _e2489.member_3, _e2489.member_4, _e2489.member_5, _e2489.member_6, _e2489.member_7, _e2489.member_8, _e2489.member_9, _e2489.member_10, _e2489.member_11, _e2489.member_12, _e2489.member_13, _e2489.member_14, _e2489.member_15, _e2489.member_16, _e2489.member_17, _e2489.member_18, _e2489.member_19, _e2466, _e2489.member_21);
let _e2533 = type_19(_e2511.member, _e2511.member_1, _e2511.member_2, _e2511.member_3, _e2511.member_4, _e2511.member_5, _e2511.member_6, _e2511.member_7, _e2511.member_8, _e2511.member_9, _e2511.member_10, _e2511.member_11, _e2511.member_12, _e2511.member_13, _e2511.member_14, _e2511.member_15, _e2511.member_16, _e2511.member_17, _e2511.member_18, _e2511.member_19, _e2511.member_20, _e2467);
let _e2536 = ((_e1745 & 2u) != 0u);
if (_e2256 && !(_e2536)) {
if (_e2466 == -1i) {
phi_3395_ = type_19(_e2533.member, _e2533.member_1, _e2533.member_2, _e2533.member_3, _e2533.member_4, _e2533.member_5, 1f, _e2533.member_7, _e2533.member_8, _e2533.member_9, _e2533.member_10, _e2533.member_11, _e2533.member_12, _e2533.member_13, _e2533.member_14, _e2533.member_15, _e2533.member_16, _e2533.member_17, _e2533.member_18, _e2533.member_19, _e2533.member_20, _e2533.member_21);
} else {
let _e2633 = type_19(vec3<f32>((_e2368.member.x + (_e2368.member_1.x * _e2467)), (_e2368.member.y + (_e2368.member_1.y * _e2467)), (_e2368.member.z + (_e2368.member_1.z * _e2467))), _e2533.member_1, _e2533.member_2, _e2533.member_3, _e2533.member_4, _e2533.member_5, _e2533.member_6, _e2533.member_7, _e2533.member_8, _e2533.member_9, _e2533.member_10, _e2533.member_11, _e2533.member_12, _e2533.member_13, _e2533.member_14, _e2533.member_15, _e2533.member_16, _e2533.member_17, _e2533.member_18, _e2533.member_19, _e2533.member_20, _e2533.member_21);
let _e2656 = type_19(_e2633.member, _e2633.member_1, _e2633.member_2, _e2633.member_3, _e2633.member_4, (0f + _e2467), _e2633.member_6, _e2633.member_7, _e2633.member_8, _e2633.member_9, _e2633.member_10, _e2633.member_11, _e2633.member_12, _e2633.member_13, _e2633.member_14, _e2633.member_15, _e2633.member_16, _e2633.member_17, _e2633.member_18, _e2633.member_19, _e2633.member_20, _e2633.member_21);
let _e2679 = type_19(_e2656.member, _e2656.member_1, _e2656.member_2, _e2656.member_3, _e2656.member_4, _e2656.member_5, _e2656.member_6, _e2656.member_7, _e2656.member_8, _e2656.member_9, _e2656.member_10, _e2656.member_11, _e2656.member_12, _e2656.member_13, _e2656.member_14, _e2656.member_15, _e2656.member_16, _e2656.member_17, _e2656.member_18, _e2656.member_19, _e2656.member_20, (_e2467 - _e2467));
let _e2706 = type_19(_e2679.member, _e2679.member_1, _e2679.member_2, _e2679.member_3, _e2679.member_4, _e2679.member_5, _e2679.member_6, _e2679.member_7, _e2679.member_8, _e2679.member_9, (_e2368.member_10 + select(0f, _e2467, (_e2368.member_8 == 0f))), _e2679.member_11, _e2679.member_12, _e2679.member_13, _e2679.member_14, _e2679.member_15, _e2679.member_16, _e2679.member_17, _e2679.member_18, _e2679.member_19, _e2679.member_20, _e2679.member_21);
phi_3395_ = type_19(_e2706.member, _e2706.member_1, _e2706.member_2, _e2706.member_3, _e2706.member_4, _e2706.member_5, 3f, _e2706.member_7, _e2706.member_8, _e2706.member_9, _e2706.member_10, _e2706.member_11, _e2706.member_12, _e2706.member_13, _e2706.member_14, _e2706.member_15, _e2706.member_16, _e2706.member_17, _e2706.member_18, _e2706.member_19, _e2706.member_20, _e2706.member_21);
}
let _e2752 = phi_3395_;
phi_3416_ = _e2752;
} else {
let _e2543 = global_1.member.member_5;
if ((!(_e2256) && (_e2368.member_8 >= f32(bitcast<i32>(_e2543)))) && (select(_e1597, _e1425.member_7, _e1672) != 16i)) {
phi_3415_ = type_19(_e2533.member, _e2533.member_1, _e2533.member_2, _e2533.member_3, _e2533.member_4, _e2533.member_5, 2f, _e2533.member_7, _e2533.member_8, _e2533.member_9, _e2533.member_10, _e2533.member_11, _e2533.member_12, _e2533.member_13, _e2533.member_14, _e2533.member_15, _e2533.member_16, _e2533.member_17, _e2533.member_18, _e2533.member_19, _e2533.member_20, _e2533.member_21);
} else {
if _e2536 {
phi_3414_ = type_19(_e2533.member, _e2533.member_1, _e2533.member_2, _e2533.member_3, _e2533.member_4, _e2533.member_5, 4f, _e2533.member_7, _e2533.member_8, _e2533.member_9, _e2533.member_10, _e2533.member_11, _e2533.member_12, _e2533.member_13, _e2533.member_14, _e2533.member_15, _e2533.member_16, _e2533.member_17, _e2533.member_18, _e2533.member_19, _e2533.member_20, _e2533.member_21);
} else {
phi_3414_ = _e2533;
}
let _e2573 = phi_3414_;
phi_3415_ = _e2573;
}
let _e2597 = phi_3415_;
phi_3416_ = _e2597;
}
let _e2754 = phi_3416_;
let _e2777 = type_19(_e2754.member, _e2754.member_1, _e2754.member_2, _e2754.member_3, _e2754.member_4, _e2754.member_5, _e2754.member_6, select(_e1425.member_7, _e1597, _e1798), _e2754.member_8, _e2754.member_9, _e2754.member_10, _e2754.member_11, _e2754.member_12, _e2754.member_13, _e2754.member_14, _e2754.member_15, _e2754.member_16, _e2754.member_17, _e2754.member_18, _e2754.member_19, _e2754.member_20, _e2754.member_21);
phi_3424_ = type_19(_e2777.member, _e2777.member_1, _e2777.member_2, _e2777.member_3, _e1566, _e2777.member_5, _e2777.member_6, _e2777.member_7, _e2777.member_8, _e2777.member_9, _e2777.member_10, _e2777.member_11, _e2777.member_12, _e2777.member_13, _e2777.member_14, _e2777.member_15, _e2777.member_16, _e2777.member_17, _e2777.member_18, _e2777.member_19, _e2777.member_20, _e2777.member_21);
} else {
phi_3424_ = _e1425;
}
let _e2801 = phi_3424_;
phi_3425_ = _e2801;
} else {
phi_3425_ = _e1425;
}
let _e2803 = phi_3425_;
phi_3426_ = _e2803;
}
let _e2805 = phi_3426_;
phi_3427_ = _e2805;
}
let _e2969 = phi_3427_;
phi_1095_ = _e2969;
phi_1098_ = (_e688 + 1i);
} else {
phi_1095_ = type_19();
phi_1098_ = i32();
}
let _e2971 = phi_1095_;
let _e2973 = phi_1098_;
continue;
continuing {
phi_1094_ = _e2971;
phi_1097_ = _e2973;
break if !(_e692);
}
}
let _e2976 = local;
let _e2980 = local_1;
let _e2984 = local_2;
let _e2988 = local_3;
let _e2992 = local_4;
let _e2996 = local_5;
let _e3000 = local_6;
let _e3004 = local_7;
let _e3008 = local_8;
let _e3012 = local_9;
let _e3016 = local_10;
let _e3020 = local_11;
let _e3024 = local_12;
let _e3028 = local_13;
let _e3032 = local_14;
let _e3036 = local_15;
let _e3039 = local_16;
let _e3043 = local_17;
let _e3046 = local_18;
let _e3049 = local_19;
let _e3052 = local_20;
let _e3055 = local_21;
let _e3059 = local_22;
let _e3063 = local_23;
let _e3067 = local_24;
let _e3071 = local_25;
let _e3075 = local_26;
let _e3079 = local_27;
let _e3083 = local_28;
let _e3087 = local_29;
let _e3091 = local_30;
let _e3095 = local_31;
let _e3099 = local_32;
let _e3103 = local_33;
let _e3107 = local_34;
let _e3111 = local_35;
let _e3115 = local_36;
let _e3119 = local_37;
let _e3123 = local_38;
let _e3127 = local_39;
let _e3131 = local_40;
let _e3135 = local_41;
let _e3139 = local_42;
global_3.member[_e122] = _e2976.member.x;
global_3.member[_e134] = _e2980.member.y;
global_3.member[_e145] = _e2984.member.z;
global_3.member[_e156] = _e2988.member_1.x;
global_3.member[_e167] = _e2992.member_1.y;
global_3.member[_e178] = _e2996.member_1.z;
global_3.member[_e189] = _e3000.member_2.x;
global_3.member[_e200] = _e3004.member_2.y;
global_3.member[_e211] = _e3008.member_2.z;
global_3.member[_e222] = _e3012.member_3.x;
global_3.member[_e233] = _e3016.member_3.y;
global_3.member[_e244] = _e3020.member_3.z;
global_3.member[_e255] = _e3024.member_4.x;
global_3.member[_e266] = _e3028.member_4.y;
global_3.member[_e277] = _e3032.member_4.z;
global_3.member[_e288] = _e3036.member_5;
let _e3176 = local_43;
global_3.member[_e299] = _e3176;
global_3.member[_e310] = f32(_e3039.member_7);
global_3.member[_e321] = _e3043.member_8;
global_3.member[_e332] = _e3046.member_9;
global_3.member[_e343] = _e3049.member_10;
global_3.member[_e354] = _e3052.member_11;
global_3.member[_e365] = _e3055.member_12.x;
global_3.member[_e376] = _e3059.member_12.y;
global_3.member[_e387] = _e3063.member_12.z;
global_3.member[_e398] = _e3067.member_13.x;
global_3.member[_e409] = _e3071.member_13.y;
global_3.member[_e420] = _e3075.member_13.z;
global_3.member[_e431] = _e3079.member_14.x;
global_3.member[_e442] = _e3083.member_14.y;
global_3.member[_e453] = _e3087.member_14.z;
global_3.member[_e464] = _e3091.member_15.x;
global_3.member[_e475] = _e3095.member_15.y;
global_3.member[_e486] = _e3099.member_15.z;
global_3.member[_e497] = _e3103.member_16.x;
global_3.member[_e508] = _e3107.member_16.y;
global_3.member[_e519] = _e3111.member_16.z;
global_3.member[_e530] = _e3115.member_17.x;
global_3.member[_e541] = _e3119.member_17.y;
global_3.member[_e552] = _e3123.member_17.z;
global_3.member[_e563] = f32(_e3127.member_18);
global_3.member[_e574] = f32(_e3131.member_19);
global_3.member[_e585] = f32(_e3135.member_20);
global_3.member[_e596] = _e3139.member_21;
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
